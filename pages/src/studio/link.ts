// The connection to the server: requests get an answer, notifications update the model. It reconnects when lost.
import { Path } from "../scene/path";
import { $, toast } from "./dom";
import { model, type Course, type Loaded, type Outline } from "./model";
import { edited, posed, type Address, type Edit } from "./pending";

export interface Answer { ok: boolean; words?: string; [key: string]: unknown; }
type Message = Record<string, any>;

const TOKEN = new URLSearchParams(location.search).get("token") ?? "";
const waiting = new Map<number, (answer: Answer) => void>();
let socket: WebSocket | null = null;
let number = 0;
let pause = 250;
const NUMBERED = new Set(["edit", "pin", "free", "mirror"]); // requests with numbers of tables in a revision
const TAB = (sessionStorage["dynsplines-tab"] ??= String(Math.random())) as string; // this tab, also after it is loaded again
const IN_USE = 4409; // close code: another tab shows the clip

const POSES = new Set(["grip", "drag", "turn"]); // what is asked to be drawn at once
let latest = 0; // number of what was asked last that may change the clip

/** When [ms] that was asked; the path that comes of it is worth more than images before it. */
export let changed = 0;

/** Whether the studio is at work on something that was asked: a processor that draws leaves it to that. */
export const isAwaiting = (): boolean => waiting.size > 0;

/** Whether that is a change of the clip. */
export const isChanging = (): boolean => waiting.has(latest);

type Sent = Edit & { done: Promise<Answer>; settle: (answer: Answer) => void };
export const pending = new Set<Sent>(); // without an answer, in the order in which they were made
let held: Sent | null = null; // the last of them, while an earlier one of its stroke has no answer
const server: { document: Outline | null; loaded: Loaded | null } = { document: null, loaded: null };

const isFinite = (value: unknown): boolean => (typeof value === "number" ? Number.isFinite(value) : value === null || typeof value !== "object" || Object.values(value).every(isFinite));

/** Shows the clip of the server with the pending edits. */
const show = (): void => {
  const edits = [...pending].filter(({ args }) => isFinite(args));
  model.document = server.document && edited(server.document, edits);
  model.loaded = server.loaded && model.stage ? posed(server.loaded, edits, model.stage) : server.loaded;
  model.tell("document");
};

/** Sends a request after every edit before it; the answer describes the result or the reason for a rejection, and never throws. */
export const ask = (what: string, args: Message = {}): Promise<Answer> => {
  flush();
  return request(what, args);
};

const request = (what: string, args: Message): Promise<Answer> => new Promise((resolve) => {
  if (!socket || socket.readyState !== WebSocket.OPEN) {
    resolve({ ok: false, words: "no connection to the studio; try again" });
    return;
  }
  number += 1;
  waiting.set(number, resolve);
  if (!POSES.has(what)) {
    latest = number;
    changed = performance.now();
  }
  const seen = NUMBERED.has(what) ? { revision: model.document?.revision } : {};
  socket.send(JSON.stringify({ do: what, id: number, ...seen, ...args }, (_, value) => (Number.isNaN(value) ? "NaN" : value)));
});

const reported = (answer: Answer): Answer => {
  if (!answer.ok) toast(answer.words ?? "the request failed", "wrong");
  else if (answer.words) toast(answer.words);
  return answer;
};

/** Sends a request and shows a rejection as a message. */
export const act = async (what: string, args: Message = {}): Promise<Answer> => reported(await ask(what, args));

/** Ends a drag at a time [s]; a message says so if nothing has moved. */
export const drop = async (time: number, nothing = "nothing has moved: locked bodies and joint ranges stay"): Promise<void> => {
  const { ok, words } = await act("drop", { time, partial: model.partial });
  if (ok && !words) toast(nothing, "note");
};

const flush = (): void => {
  const next = held;
  held = null;
  if (next) send(next);
};

const send = (edit: Sent): void => {
  const { name, args, stroke } = edit;
  void request("edit", { name, ...args, stroke }).then((answer) => {
    pending.delete(edit);
    if (held?.stroke === stroke) flush();
    show();
    edit.settle(reported(answer));
  });
};

/** Edits the clip: the page shows it at once, and what the server makes of it later. Edits of one stroke are undone together. */
export const edit = (name: string, given: Message, stroke?: string): Promise<Answer> => {
  const args: Message = { revision: model.document?.revision, ...given };
  if (held && stroke && held.stroke === stroke && held.name === name && String(held.args.at) === String(args.at)) {
    held.args = args;
    show();
    return held.done;
  }
  flush();
  let settle: Sent["settle"] = () => {};
  const done = new Promise<Answer>((resolve) => { settle = resolve; }), made = { name, args, stroke, done, settle };
  if (stroke && [...pending].some((each) => each.stroke === stroke)) held = made;
  pending.add(made);
  if (held !== made) send(made);
  show();
  return done;
};

/** Sets entries of a table; null removes one. */
export const change = (at: Address, entries: Message, revision = model.document?.revision, stroke?: string): Promise<Answer> => edit("change", { at, entries, revision }, stroke);

/** Moves keyframes to times [s]; the playhead stays at its keyframe. */
export const moveKeys = async (moves: [number, number][], revision = model.document?.revision, stroke?: string): Promise<void> => {
  const { here } = model, to = moves.find(([i]) => i === here)?.[1];
  const done = edit("move_keys", { moves, revision }, stroke);
  if (here === null || to === undefined || !Number.isFinite(to)) return;
  model.seek(to);
  if (!(await done).ok) model.seek(model.document!.keys[here].time);
};

export const addressOf = ({ kind, index }: { kind: string; index: number }): Address => (kind === "step" ? ["scene", kind] : ["scene", kind, index]);

const packed = (data: ArrayBuffer): void => {
  const size = new DataView(data).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, size))) as Message & Course;
  const { count, bodies } = head;
  let at = 4 + size;
  const taken = (length: number) => { const out = new Float32Array(data, at, length); at += 4 * length; return out; };
  const path = new Path(head.first, head.last, head.rate, count, bodies, taken(3 * count * bodies), taken(4 * count * bodies), taken(3 * count));
  if (head.kind === "raw") model.raw = path;
  else {
    model.now = path;
    model.course = head;
    model.frames += 1;
  }
  model.tell("path");
};

/** Shows a notice on the stage, or hides it if it has no words. */
const notice = ({ is, words, loads }: Message): void => {
  $(is).hidden = words === null;
  $(`${is}-words`).textContent = words ?? "";
  if (is === "outside") $("outside-reload").hidden = !loads;
  model.tell(is);
};

const HANDLERS: Record<string, (message: Message) => void> = {
  stage: (message) => { model.stage = message.stage; model.tell("stage"); },
  document: (message) => {
    const before = server.document, now = message as never as Outline;
    const isRenumbered = (...lists: ("keys" | "contacts" | "grasps" | "obstacles")[]) => lists.some((list) => before?.[list].length !== now[list].length);
    server.document = now;
    const times = [...model.keys].map((i) => before?.keys[i]?.time ?? NaN);
    if (isRenumbered("contacts", "grasps")) model.bar = null;
    if (model.obstacle && isRenumbered("obstacles")) { model.obstacle = null; model.tell("joint"); }
    show();
    if (isRenumbered("keys")) model.select(model.at(model.keys.size > 1 ? times : [model.time]));
  },
  loaded: (message) => { server.loaded = message as never; show(); model.tell("loaded"); },
  settled: (message) => { model.violations = message.violations; model.overshoots = message.overshoots; model.tell("settled"); },
  status: (message) => { model.status = message as never; model.tell("status"); },
  kinds: (message) => { model.kinds = message.kinds; model.tell("kinds"); },
  curves: (message) => { model.curves = message.curves; model.tell("curves"); },
  poses: (message) => { model.poses = message.names; model.tell("poses"); },
  task: notice,
  offer: notice,
  outside: notice,
  note: (message) => toast(message.words, "note"),
  refused: (message) => toast(message.words, "wrong"),
  gone: (message) => toast(message.words, "wrong"),
  answer: (message) => { waiting.get(message.id)?.(message as never); waiting.delete(message.id); },
};

/** Whether this tab is connected, or why not: another one shows the clip, or the studio does not answer. */
export let connection: "open" | "elsewhere" | "lost" = "lost";

/** Connects to the studio; with `take`, instead of the tab that shows the clip. */
export const connect = (take = false): void => {
  const line = new WebSocket(`ws${location.protocol === "https:" ? "s" : ""}://${location.host}/line?token=${encodeURIComponent(TOKEN)}&tab=${TAB}${take ? "&take" : ""}`);
  line.binaryType = "arraybuffer";
  socket = line;
  line.onopen = () => { connection = "open"; $("elsewhere").hidden = true; pause = 250; model.tell("line"); };
  line.onmessage = ({ data }) => {
    if (data instanceof ArrayBuffer) { packed(data); return; }
    const message = JSON.parse(data) as Message;
    HANDLERS[message.is]?.(message);
  };
  line.onclose = ({ code }) => {
    connection = code === IN_USE ? "elsewhere" : "lost";
    for (const resolve of waiting.values()) resolve({ ok: false, words: "connection to the studio lost; check whether the change was applied" });
    waiting.clear();
    $("elsewhere").hidden = connection !== "elsewhere";
    model.tell("line");
    if (connection === "elsewhere") return;
    window.setTimeout(connect, pause);
    pause = Math.min(2 * pause, 4000);
  };
};
