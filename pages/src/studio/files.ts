// Files: save as, export, render.
import { $, el } from "./dom";
import { act, ask } from "./link";
import { model } from "./model";

const dialog = (title: string, ...inside: Node[]): HTMLDialogElement => {
  const box = el("dialog", { "aria-label": title });
  box.append(el("form", { method: "dialog" }, el("h2", { text: title }), ...inside));
  box.addEventListener("close", () => box.remove());
  document.body.append(box);
  box.showModal();
  return box;
};

const row = (label: string, field: HTMLElement): HTMLElement => el("label", { class: "line" }, el("span", { text: label }), field);

const closing = (box: () => HTMLDialogElement, name: string, done: () => Promise<boolean>): HTMLElement => {
  const go = el("button", { type: "submit", class: "main", text: name });
  go.addEventListener("click", (event) => {
    event.preventDefault();
    void done().then((ok) => { if (ok) box().close(); });
  });
  return el("div", { class: "buttons end" }, el("button", { type: "button", text: "Cancel", onclick: () => box().close() }), go);
};

const replacing = (): [HTMLInputElement, HTMLElement] => {
  const over = el("input", { type: "checkbox" });
  return [over, el("label", { class: "line" }, over, " overwrite an existing file")];
};

const base = (): string => (model.document?.name ?? "clip").replace(/[^\w.-]+/g, "_");

export const saveAs = (): void => {
  const name = el("input", { type: "text", value: `${base()}.toml`, "aria-label": "file name" });
  const [over, line] = replacing();
  const box = dialog("Save as", row("name", name), line,
    closing(() => box, "Save", async () => (await act("save", { name: name.value, overwrite: over.checked })).ok));
  name.select();
};

export const exported = async (): Promise<void> => {
  const answer = await ask("formats");
  if (!answer.ok) return;
  const formats = answer.formats as { name: string; ending: string; description: string }[];
  const to = el("select", { "aria-label": "format" }, ...formats.map((each) => el("option", { value: each.name, text: `${each.name} – ${each.description}` })));
  const name = el("input", { type: "text", "aria-label": "file name" });
  const ended = (): void => { name.value = `${base()}${formats.find((each) => each.name === to.value)?.ending.split(/[ ,]/)[0] ?? ""}`; };
  to.addEventListener("change", ended);
  ended();
  const [over, line] = replacing();
  const box = dialog("Export", row("format", to), row("name", name), line,
    closing(() => box, "Export", async () => { void act("export", { to: to.value, name: name.value, overwrite: over.checked }); return true; }));
};

export const rendered = (): void => {
  const name = el("input", { type: "text", value: `${base()}.mp4`, "aria-label": "file name of the video" });
  const size = el("input", { type: "text", value: "1280x720", "aria-label": "size, pixels" });
  const camera = el("select", { "aria-label": "camera" }, ...["side", "left", "front", "three_quarter", "back"].map((each) => el("option", { value: each, text: each })));
  const only = el("select", { "aria-label": "view" }, el("option", { value: "after", text: "the motion" }), el("option", { value: "", text: "before | after" }));
  const [over, line] = replacing();
  const box = dialog("Render", row("name, .mp4 .webm .gif .png", name), row("size", size), row("camera", camera), row("what", only), line,
    closing(() => box, "Render", async () => { void act("render", { name: name.value, size: size.value, camera: camera.value, only: only.value, overwrite: over.checked }); return true; }));
};

export const beginFiles = (): void => {
  const menu = $("files");
  menu.addEventListener("save-as", saveAs);
  const items: [string, () => void][] = [["Save as …", saveAs], ["Export …", () => void exported()], ["Render …", rendered]];
  const list = el("div", { class: "menu", role: "menu", hidden: true }, ...items.map(([text, done]) => el("button", { type: "button", role: "menuitem", text, onclick: () => { list.hidden = true; menu.setAttribute("aria-expanded", "false"); done(); } })));
  menu.after(list);
  menu.addEventListener("click", () => {
    list.hidden = !list.hidden;
    menu.setAttribute("aria-expanded", String(!list.hidden));
    if (!list.hidden) list.querySelector("button")!.focus();
  });
  list.addEventListener("keydown", (event) => {
    const all = [...list.querySelectorAll("button")], at = all.indexOf(document.activeElement as HTMLButtonElement);
    if (event.key === "Escape") { list.hidden = true; menu.focus(); event.stopPropagation(); }
    if (event.key === "ArrowDown") all[(at + 1) % all.length].focus();
    if (event.key === "ArrowUp") all[(at + all.length - 1) % all.length].focus();
  });
  document.addEventListener("pointerdown", (event) => { if (!list.contains(event.target as Node) && event.target !== menu && !menu.contains(event.target as Node)) list.hidden = true; });
};
