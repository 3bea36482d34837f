// Files: save as, export, render.
import { $, el } from "./dom";
import { act, ask, connect } from "./link";
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

/** Ends a dialog: Enter, or its button, does what it is for; a refusal leaves it open. */
const closing = (box: () => HTMLDialogElement, name: string, done: () => Promise<boolean>): HTMLElement => {
  const go = el("button", { type: "submit", class: "main", text: name });
  const submit = (event: Event): void => {
    event.preventDefault();
    if (go.disabled) return;
    go.disabled = true;
    void done().then((ok) => { go.disabled = false; if (ok) box().close(); });
  };
  go.addEventListener("click", submit);
  queueMicrotask(() => box().addEventListener("keydown", (event) => { if (event.key === "Enter" && !(event.target as HTMLElement).matches("button")) submit(event); }));
  return el("div", { class: "buttons end" }, el("button", { type: "button", text: "Cancel", onclick: () => box().close() }), go);
};

/** Whether a file is being written, or has been; a refusal is shown. */
const begun = (what: string, args: object): Promise<boolean> => {
  const started = new Promise<boolean>((resolve) => { starts = () => resolve(true); });
  return Promise.race([act(what, args as Record<string, unknown>).then(({ ok }) => ok), started]);
};
let starts = (): void => {}; // called when a file begins to be written
model.on("task", () => { if (!$("task").hidden) starts(); });

const base = (): string => (model.document?.name ?? "clip").replace(/[^\w.-]+/g, "_");

/** A dialog that writes a file of a name; `rows` are further fields. */
const writing = (title: string, done: string, field: HTMLInputElement, rows: HTMLElement[], write: (file: { name: string; overwrite: boolean }) => Promise<boolean>): void => {
  const over = el("input", { type: "checkbox" });
  const box = dialog(title, ...rows, el("label", { class: "line" }, over, " overwrite an existing file"),
    closing(() => box, done, () => write({ name: field.value, overwrite: over.checked })));
  field.select();
};
const named = (value: string, label = "file name"): HTMLInputElement => el("input", { type: "text", value, "aria-label": label });
const accepted = async (what: string, args: object): Promise<boolean> => (await act(what, { ...args })).ok;

export const saveAs = (): void => {
  const name = named(`${base()}.toml`);
  writing("Save as", "Save", name, [row("name", name)], (file) => accepted("save", file));
};

/** Saves the pose at a time [s]. */
export const savePose = (time = model.moment): void => {
  const name = named("", "name of the pose");
  writing("Save pose", "Save", name, [row("name", name)], (file) => accepted("save_pose", { time, ...file }));
};

/** A new clip of a figure. */
const anew = async (): Promise<void> => {
  const answer = await ask("figures");
  if (!answer.ok) return;
  const figure = el("select", { "aria-label": "figure" }, ...(answer.figures as string[]).map((name) => el("option", { value: name, text: name })));
  const box = dialog("New", row("figure", figure), closing(() => box, "Create", async () => {
    const ok = await accepted("new", { figure: figure.value });
    if (ok) model.seek(0);
    return ok;
  }));
};

const exported = async (): Promise<void> => {
  const answer = await ask("formats");
  if (!answer.ok) return;
  const formats = answer.formats as { name: string; ending: string; description: string }[];
  const to = el("select", { "aria-label": "format" }, ...formats.map((each) => el("option", { value: each.name, text: `${each.name} – ${each.description}` })));
  const name = named("");
  const ended = (): void => { name.value = `${base()}${formats.find((each) => each.name === to.value)?.ending.split(/[ ,]/)[0] ?? ""}`; };
  to.addEventListener("change", ended);
  ended();
  writing("Export", "Export", name, [row("format", to), row("name", name)], (file) => begun("export", { to: to.value, ...file }));
};

const rendered = (): void => {
  const name = named(`${base()}.mp4`, "file name of the video"), size = named("1280x720", "size, pixels");
  const camera = el("select", { "aria-label": "camera" }, ...["side", "left", "front", "three_quarter", "back"].map((each) => el("option", { value: each, text: each })));
  const only = el("select", { "aria-label": "view" }, el("option", { value: "after", text: "the motion" }), el("option", { value: "", text: "before | after" }));
  writing("Render", "Render", name, [row("name, .mp4 .webm .gif .png", name), row("size", size), row("camera", camera), row("what", only)],
    (file) => begun("render", { size: size.value, camera: camera.value, only: only.value, ...file }));
};

export const beginFiles = (): void => {
  const answers: Record<string, () => unknown> = {
    "outside-reload": () => act("reload"), "outside-keep": () => act("keep"), "outside-save-as": saveAs, "task-stop": () => act("stop"),
    "offer-take": () => act("take_offer", { yes: true }), "offer-drop": () => act("take_offer", { yes: false }), "take-over": () => connect(true),
  };
  for (const [id, done] of Object.entries(answers)) $(id).addEventListener("click", done);
  const menu = $("files");
  menu.addEventListener("save-as", saveAs);
  const items: [string, () => void][] = [["New …", () => void anew()], ["Save as …", saveAs], ["Export …", () => void exported()], ["Render …", rendered]];
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
