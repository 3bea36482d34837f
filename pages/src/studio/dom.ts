// Elements made in one line, and the few icons.
type Props = Record<string, string | number | boolean | undefined | ((event: Event) => void)>;

export const $ = <T extends HTMLElement = HTMLElement>(id: string): T => document.getElementById(id) as T;

/** An element: attributes, `text`, handlers as onclick and so on, children. */
export const el = <K extends keyof HTMLElementTagNameMap>(
  tag: K, props: Props = {}, ...children: (Node | string)[]
): HTMLElementTagNameMap[K] => {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(props)) {
    if (typeof value === "function") made.addEventListener(name.slice(2), value);
    else if (name === "text") made.textContent = String(value);
    else if (value === true) made.setAttribute(name, "");
    else if (value !== false && value !== undefined) made.setAttribute(name, String(value));
  }
  made.append(...children);
  return made;
};

const PATHS: Record<string, string> = {
  play: "M7 4.5v15l12.500-7.500z",
  pause: "M6 4.5h4.200v15H6zM13.800 4.500H18v15h-4.200z",
  previous: "M5 5h2.4v14H5zM19 5v14L8.600 12z",
  next: "M16.600 5H19v14h-2.400zM5 5v14l10.400-7z",
  undo: "M9 5 3.500 10.500 9 16v-3.600h5a4 4 0 0 1 0 8h-3v2.100h3a6.100 6.100 0 0 0 0-12.200H9z",
  redo: "M15 5l5.500 5.500L15 16v-3.600h-5a4 4 0 0 0 0 8h3v2.100h-3a6.100 6.100 0 0 1 0-12.200h5z",
  save: "M4 4h12.500L20 7.500V20H4zM7 6v4.500h8V6zM12 12.800a2.700 2.700 0 1 0 0 5.400 2.700 2.700 0 0 0 0-5.400z",
  menu: "M4 6h16v2.200H4zM4 11h16v2.200H4zM4 16h16v2.200H4z",
  theme: "M12 3a9 9 0 1 0 0 18zM12 5.200v13.600a6.800 6.800 0 0 0 0-13.600z",
  key: "M12 3.500 20.500 12 12 20.500 3.500 12z",
  plus: "M10.900 4h2.200v6.900H20v2.200h-6.900V20h-2.200v-6.900H4v-2.200h6.900z",
  bin: "M9 3h6l1 2h4v2.200H4V5h4zM5.500 8.500h13L17.500 21h-11z",
  fold: "M8 5l8 7-8 7z",
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

/** A button with an icon; its name is for the tooltip and for screen readers. */
export const button = (name: string, title: string, onclick: () => void, keys = ""): HTMLButtonElement => {
  const made = el("button", { type: "button", class: "tool", title: keys ? `${title} (${keys})` : title, "aria-label": title, onclick });
  made.append(icon(name));
  return made;
};

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

/** A number with as many digits as it takes. */
export const short = (value: number, digits = 3): string => String(+value.toFixed(digits));
