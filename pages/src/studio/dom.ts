// Elements made in one line, and the few icons.
type Props = Record<string, string | number | boolean | undefined | ((event: Event) => void)>;

export const $ = <T extends HTMLElement = HTMLElement>(id: string): T => document.getElementById(id) as T;

/** An element: attributes, `text`, handlers as onclick and so on, children. */
export const el = <K extends keyof HTMLElementTagNameMap>(
  tag: K, props: Props = {}, ...children: (Node | string)[]
): HTMLElementTagNameMap[K] => {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(props)) {
    if (typeof value === "function") Object.assign(made, { [name]: value });
    else if (name === "text") made.textContent = String(value);
    else if (value === true) made.setAttribute(name, "");
    else if (value !== false && value !== undefined) made.setAttribute(name, String(value));
  }
  made.append(...children);
  return made;
};

const HANDLERS = ["onclick", "onchange", "oninput", "onkeydown", "onpointerdown"] as const;

/** What says that two elements stand for the same: the fields of a form by their names. */
const identity = (node: Node): string => (node instanceof HTMLElement ? `${node.tagName} ${node.dataset.id ?? node.getAttribute("aria-label") ?? ""}` : node.nodeName);

/** Makes the children of an element like those given. Elements that stand for the same remain, with focus and what is being typed. */
export const fill = (box: Element, ...children: (Node | string)[]): void => {
  let at = box.firstChild;
  for (const each of children) {
    const made = typeof each === "string" ? document.createTextNode(each) : each;
    let old = at;
    while (old && identity(old) !== identity(made)) old = old.nextSibling;
    if (!old) { box.insertBefore(made, at); continue; }
    while (at && at !== old) { const { nextSibling } = at; at.remove(); at = nextSibling; }
    liken(old, made);
    at = old.nextSibling;
  }
  while (at) { const { nextSibling } = at; at.remove(); at = nextSibling; }
};

const liken = (old: Node, made: Node): void => {
  if (!(old instanceof HTMLElement) || !(made instanceof HTMLElement)) {
    if (old.textContent !== made.textContent) old.textContent = made.textContent;
    return;
  }
  for (const { name } of [...old.attributes]) if (name !== "data-typed" && !made.hasAttribute(name)) old.removeAttribute(name);
  for (const { name, value } of [...made.attributes]) if (old.getAttribute(name) !== value) old.setAttribute(name, value);
  for (const name of HANDLERS) Object.assign(old, { [name]: made[name] });
  fill(old, ...made.childNodes);
  const isBusy = old.dataset.typed !== undefined || (old === document.activeElement && old.matches("[type=range]:active"));
  if ((old instanceof HTMLInputElement || old instanceof HTMLSelectElement) && !isBusy) {
    const { value, checked } = made as HTMLInputElement;
    if (old.value !== value) old.value = value;
    if (old instanceof HTMLInputElement) old.checked = checked;
  }
};

export const PATHS: Record<string, string> = {
  play: "M7 4.5v15l12.500-7.500z",
  pause: "M6 4.5h4.200v15H6zM13.800 4.500H18v15h-4.200z",
  previous: "M5 5h2.4v14H5zM19 5v14L8.600 12z",
  next: "M16.600 5H19v14h-2.400zM5 5v14l10.400-7z",
  undo: "M9 5 3.500 10.500 9 16v-3.600h5a4 4 0 0 1 0 8h-3v2.100h3a6.100 6.100 0 0 0 0-12.200H9z",
  redo: "M15 5l5.500 5.500L15 16v-3.600h-5a4 4 0 0 0 0 8h3v2.100h-3a6.100 6.100 0 0 1 0-12.200h5z",
  save: "M4 4h12.500L20 7.500V20H4zM7 6v4.500h8V6zM12 12.800a2.700 2.700 0 1 0 0 5.400 2.700 2.700 0 0 0 0-5.400z",
  lock: "M6.500 10V8a5.500 5.500 0 0 1 11 0v2h1.500v11H5V10zM9 10h6V8a3 3 0 0 0-6 0z",
  menu: "M4 6h16v2.200H4zM4 11h16v2.200H4zM4 16h16v2.200H4z",
  theme: "M12 3a9 9 0 1 0 0 18zM12 5.200v13.600a6.800 6.800 0 0 0 0-13.600z",
  key: "M12 3.500 20.500 12 12 20.500 3.500 12z",
  bin: "M9 3h6l1 2h4v2.200H4V5h4zM5.500 8.500h13L17.500 21h-11z",
};

export const icon = (name: string): SVGSVGElement => {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 24 24");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", PATHS[name]);
  path.setAttribute("fill-rule", "evenodd");
  svg.append(path);
  return svg;
};

/** Sets an element's text if it differs: unchanged text is not laid out again. */
export const say = (where: Element, text: string): void => { if (where.textContent !== text) where.textContent = text; };

let fading = 0;
/** A line at the bottom of the stage; what went wrong stays longer. */
export const toast = (words: string, kind: "done" | "wrong" | "note" = "done"): void => {
  if (!words) return;
  const line = $("toast");
  line.textContent = words;
  line.className = kind;
  line.setAttribute("role", kind === "wrong" ? "alert" : "status");
  line.hidden = false;
  window.clearTimeout(fading);
  fading = window.setTimeout(() => { line.hidden = true; }, kind === "wrong" ? 9000 : 2600);
};

/** A menu at a place of the page; `done` is called with the chosen entry, or null. */
export const menu = (title: string, at: { clientX: number; clientY: number }, entries: string[], done: (chosen: string | null) => void): void => {
  const box = el("dialog", { class: "menu", "aria-label": title });
  const end = (chosen: string | null): void => { // at once: the event "close" may come after the next input
    if (!box.isConnected) return;
    box.close();
    box.remove();
    done(chosen);
  };
  box.append(el("p", { class: "hint", text: title }), ...entries.map((text) => el("button", { type: "button", text, onclick: () => end(text) })));
  box.addEventListener("close", () => end(null));
  box.addEventListener("click", (event) => { if (event.target === box) end(null); });
  document.body.append(box);
  box.showModal();
  const { width, height } = box.getBoundingClientRect();
  box.style.left = `${Math.max(4, Math.min(at.clientX, innerWidth - width - 8))}px`;
  box.style.top = `${Math.max(4, Math.min(at.clientY, innerHeight - height - 8))}px`;
  box.querySelector("button")?.focus();
};

/** A number with as many digits as it takes. */
export const short = (value: number, digits = 3): string => String(+value.toFixed(digits));

/** Calls a function once before the next image is drawn, however often it is asked for. */
export const soon = (done: () => void): (() => void) => {
  let waiting = false;
  return () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => { waiting = false; done(); });
  };
};

const PRESSES = 1000; // [ms] between two presses of one run, which is undone as one
const SCRUB = 4; // [px] of the mouse for each step of a value
let run = { field: "", at: -Infinity, stroke: "" };
/** The name of a run of changes: of the last one, if it was of the same and a moment ago. */
export const strokeOf = (field: string): string => {
  const now = performance.now();
  if (run.field !== field || now - run.at > PRESSES) run.stroke = String(Math.random());
  run = { ...run, field, at: now };
  return run.stroke;
};

/** What is in a field: a number, or NaN for what is none, which the studio refuses in words. */
const read = (field: HTMLInputElement): number => {
  const text = field.value.trim().replace(",", ".");
  return text === "" ? NaN : Number(text);
};

/** A field for a number: typed, changed by arrow keys, or by dragging it sideways. Changes of one stroke are undone together. */
export const numberField = (label: string, value: number, unit: string, changed: (value: number, stroke?: string) => void, step = 1, digits = 3): HTMLInputElement => {
  const by = (field: HTMLInputElement, steps: number): void => {
    field.value = short(read(field) + steps * step, digits);
    delete field.dataset.typed;
    changed(read(field), strokeOf(label));
  };
  return el("input", {
    type: "text", inputmode: "decimal", class: "number", value: short(value, digits), "aria-label": `${label} [${unit}]`,
    title: `${label} [${unit}]; arrow keys or dragging change it`,
    oninput: ({ currentTarget }) => { (currentTarget as HTMLElement).dataset.typed = ""; },
    onchange: ({ currentTarget }) => {
      const field = currentTarget as HTMLInputElement;
      if (field.dataset.typed === undefined) return; // an arrow key has changed it
      delete field.dataset.typed;
      changed(read(field));
    },
    onkeydown: (event) => {
      const field = event.currentTarget as HTMLInputElement, { key, shiftKey } = event as KeyboardEvent;
      if (key === "Enter") field.blur();
      if (key === "Escape") { delete field.dataset.typed; field.value = short(value, digits); field.blur(); event.stopPropagation(); }
      if (key !== "ArrowUp" && key !== "ArrowDown") return;
      event.preventDefault();
      by(field, (key === "ArrowUp" ? 1 : -1) * (shiftKey ? 10 : 1));
    },
    onpointerdown: (event) => {
      const field = event.currentTarget as HTMLInputElement, begin = (event as PointerEvent).clientX;
      if (field === document.activeElement || (event as PointerEvent).button !== 0) return;
      let done = 0, scrubs = false;
      const move = (e: PointerEvent): void => {
        const steps = Math.trunc((e.clientX - begin) / SCRUB);
        if (steps === done) return;
        scrubs = true;
        by(field, (steps - done) * (e.shiftKey ? 10 : 1));
        done = steps;
      };
      const up = (): void => {
        window.removeEventListener("pointermove", move);
        window.removeEventListener("pointerup", up);
        if (scrubs) field.blur();
      };
      window.addEventListener("pointermove", move);
      window.addEventListener("pointerup", up);
    },
  });
};
