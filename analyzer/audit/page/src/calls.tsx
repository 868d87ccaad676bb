// Who calls whom around a program, drawn by Graphviz, which is started at the first drawing.
import { useEffect, useRef, useState } from "preact/hooks";
import { unpacked } from "./data";
import type { Model } from "./model";
import { link } from "./route";
import { visible } from "./words";

type Viz = { renderString(dot: string, options: { format: string }): string };
let viz: Promise<Viz> | undefined;

function graphviz(): Promise<Viz> {
  viz ??= unpacked("owlint-engine").then((code) => new Function(`${code};return owlintEngine`)().instance() as Promise<Viz>);
  return viz;
}

/** Only shapes and text are kept of what Graphviz made. */
function cleaned(svg: string): SVGSVGElement {
  const root = new DOMParser().parseFromString(svg, "image/svg+xml").documentElement as unknown as SVGSVGElement;
  for (const element of [...root.querySelectorAll("*")]) {
    if (!["g", "text", "polygon", "ellipse", "path", "polyline"].includes(element.localName)) element.remove();
    for (const { name } of [...element.attributes]) if (name.startsWith("on") || name.endsWith("href")) element.removeAttribute(name);
  }
  return root;
}

const quoted = (words: string) => visible(words).replace(/[\\"]/g, "\\$&");
const end = (words: string, most: number) => (words.length > most ? `…${words.slice(1 - most)}` : words);

/** DOT of what a program calls, and of what calls it. Nodes have the class `goto-` with the number of their file. */
export function callGraph(model: Model, file: number): string {
  const most = 150;
  const nodes = new Set([file]);
  const edges: string[] = [];
  const queue = [file];
  let left = 0;
  while (queue.length > 0) {
    const from = queue.shift()!;
    for (const to of model.calls(from)) {
      if (!nodes.has(to) && nodes.size >= most) { ++left; continue; }
      if (!nodes.has(to)) { nodes.add(to); queue.push(to); }
      edges.push(`n${from} -> n${to};`);
    }
  }
  for (const from of model.callers(file)) {
    if (nodes.has(from)) continue;
    if (nodes.size >= most) { ++left; continue; }
    nodes.add(from);
    edges.push(`n${from} -> n${file};`);
  }
  const parts = (f: number) => {
    const slash = model.paths[f].lastIndexOf("/");
    return [model.paths[f].slice(0, Math.max(0, slash)), model.paths[f].slice(slash + 1)];
  };
  // The name says what is called; the folder only where it is another one than that of the program.
  const label = (f: number) => {
    const [folder, name] = parts(f);
    const sign = model.counts[2][f] > 0 ? "✕ " : model.counts[1][f] > 0 ? "! " : "";
    return sign + quoted(end(name, 40)) + (folder === parts(file)[0] ? "" : `\\n${quoted(folder === "" ? "top folder" : end(folder, 32))}`);
  };
  const kind = (f: number) => `goto-${f}${model.counts[2][f] > 0 ? " error" : model.counts[1][f] > 0 ? " warning" : ""}${f === file ? " here" : ""}`;
  const more = left > 0 ? `more [label="and ${left} more", shape=plaintext];` : "";
  return `digraph calls { rankdir=LR; ranksep=0.35; nodesep=0.15; node [shape=box, fontname="Courier"]; ${[...nodes].map((f) => `n${f} [label="${label(f)}", class="${kind(f)}"];`).join(" ")} ${edges.join(" ")} ${more} }`;
}

/** Makes the nodes links, and says how large the drawing is. */
function prepared(svg: SVGSVGElement): { width: number; height: number } {
  svg.setAttribute("role", "group");
  svg.setAttribute("aria-label", "programs that call this one, and that it calls");
  for (const node of svg.querySelectorAll<SVGGElement>("g.node")) {
    const texts = [...node.querySelectorAll("text")];
    texts.slice(1).forEach((folder) => folder.classList.add("folder"));
    const file = [...node.classList].find((c) => /^goto-\d+$/.test(c))?.slice(5);
    if (!file) continue;
    const go = () => { location.hash = link("program", file); };
    node.setAttribute("role", "link");
    node.setAttribute("tabindex", "0");
    node.setAttribute("aria-label", texts.map((t) => t.textContent).join(" in "));
    node.addEventListener("click", go);
    node.addEventListener("keydown", (event) => { if (event.key === "Enter") go(); });
  }
  const [, , width, height] = svg.getAttribute("viewBox")!.split(" ").map(Number);
  return { width, height };
}

export function CallsView({ model, file }: { model: Model; file: number }) {
  const smallest = 0.85;  // below it the names are hard to read: a large drawing is moved rather than shrunk
  const box = useRef<HTMLDivElement>(null);
  const size = useRef({ width: 0, height: 0 });
  const [state, setState] = useState("Drawing…");
  const [scale, setScale] = useState(1);
  const fitting = (least: number) => {
    const { clientWidth, clientHeight } = box.current!;
    const { width, height } = size.current;
    return Math.min(1, Math.max(least, Math.min(clientWidth / width, least > 0 ? 1 : clientHeight / height)));
  };
  useEffect(() => {
    let current = true;
    graphviz().then((engine) => {
      if (!current || !box.current) return;
      const svg = cleaned(engine.renderString(callGraph(model, file), { format: "svg" }));
      size.current = prepared(svg);
      box.current.replaceChildren(svg);
      setScale(fitting(smallest));
      setState("");
    }, (problem) => current && setState(`It could not be drawn: ${problem}`));
    return () => { current = false; };
  }, [file]);
  useEffect(() => {
    const svg = box.current?.querySelector("svg");
    if (state !== "" || !svg) return;
    svg.setAttribute("width", String(size.current.width * scale));
    svg.setAttribute("height", String(size.current.height * scale));
  }, [scale, state]);
  useEffect(() => {  // the program itself is in view, whatever the size
    const here = box.current?.querySelector("g.here");
    if (state !== "" || !here) return;
    const [node, frame] = [here.getBoundingClientRect(), box.current!.getBoundingClientRect()];
    box.current!.scrollBy(node.x + node.width / 2 - frame.x - frame.width / 2, node.y + node.height / 2 - frame.y - frame.height / 2);
  }, [state]);
  const larger = () => setScale((s) => Math.min(4, s * 1.25));
  const smaller = () => setScale((s) => Math.max(0.1, s / 1.25));
  const whole = () => setScale(fitting(0));
  const keys = (event: KeyboardEvent) => {
    const action = { "+": larger, "-": smaller, "0": whole }[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  };
  return (
    <div class="graph" onKeyDown={keys}>
      <div class="tools"><button type="button" onClick={larger} aria-label="larger">+</button><button type="button" onClick={smaller} aria-label="smaller">−</button><button type="button" onClick={whole}>whole</button></div>
      {state && <p role="status">{state}</p>}
      <div class="drawing" ref={box} tabIndex={0} role="region" aria-label="calls; plus and minus change the size, 0 shows the whole drawing" />
    </div>
  );
}
