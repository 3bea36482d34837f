// The studio's page: everything that it is made of, begun in order.
import "uplot/dist/uPlot.min.css";
import "./style.css";
import { beginCurves, dots, onPlot } from "./curves";
import { $, el, icon } from "./dom";
import { beginFiles } from "./files";
import { Gizmo } from "./gizmo";
import { Hands } from "./hands";
import { beginKeyboard } from "./keyboard";
import { ask, connect, pending } from "./link";
import { model } from "./model";
import { beginPanels } from "./panels";
import { Stage } from "./stage";
import { Timeline } from "./timeline";
import { Trails } from "./trails";
import { transport } from "./transport";

const themed = (): void => {
  const wanted = localStorage.getItem("dynsplines-theme") ?? "dark";
  document.documentElement.dataset.theme = wanted;
};
themed();
connect(); // messages arrive after this script has run

try {
  const stage = new Stage();
  const gizmo = new Gizmo(stage);
  const hands = new Hands(stage);
  const timeline = new Timeline();
  new Trails(stage);
  beginPanels();
  beginCurves(timeline);
  beginFiles();
  beginKeyboard(stage, timeline, hands);
  transport(stage);
  $("files").prepend(icon("menu"));
  $("theme").append(icon("theme"));
  $("theme").addEventListener("click", () => {
    localStorage.setItem("dynsplines-theme", document.documentElement.dataset.theme === "light" ? "dark" : "light");
    themed();
    model.tell("theme");
  });
  model.on("stage", () => { $("waiting").hidden = true; });
  model.on("status", () => { if (!model.stage && model.status.words) { $("waiting").textContent = model.status.words; $("waiting").hidden = false; } });
  model.tell("theme");
  // For tests and measures
  Object.assign(window, { studio: { ask, pending, model, stage, hands, gizmo, timeline, dots, onPlot } });
} catch (error) {
  $("waiting").replaceChildren(el("p", { text: `This browser cannot draw in three dimensions: WebGL 2 is missing or switched off. (${error})` }));
}
