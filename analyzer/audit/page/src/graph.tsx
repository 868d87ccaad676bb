// Drawings: the blocks of a program, and who calls whom around it. Laid out by Graphviz, which is started at the first one.
import { select } from "d3-selection";
import { zoom, zoomIdentity, type ZoomBehavior } from "d3-zoom";
import { useEffect, useRef, useState } from "preact/hooks";
import { unpacked } from "./data";
import type { Model } from "./model";

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
    if (!["g", "title", "text", "polygon", "ellipse", "path", "polyline", "a"].includes(element.localName)) element.remove();
    for (const { name } of [...element.attributes]) if (name.startsWith("on") || name.endsWith("href")) element.removeAttribute(name);
  }
  return root;
}

interface Target { file: number; line: number }

const text = (words: string) => words.replace(/[\\"]/g, "\\$&").replace(/[\u0000-\u001f]/g, "�");

/** DOT of what a program calls, and of what calls it. */
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
  const label = (f: number) => {
    const sign = model.counts[2][f] > 0 ? "✕ " : model.counts[1][f] > 0 ? "! " : "";
    return sign + text(model.shown[f].length > 60 ? `…${model.shown[f].slice(-58)}` : model.shown[f]);
  };
  const kind = (f: number) => `goto-${f}${model.counts[2][f] > 0 ? " error" : model.counts[1][f] > 0 ? " warning" : ""}${f === file ? " here" : ""}`;
  const more = left > 0 ? `more [label="and ${left} more", shape=plaintext];` : "";
  return `digraph calls { rankdir=LR; node [shape=box, fontname="Courier"]; ${[...nodes].map((f) => `n${f} [label="${label(f)}", class="${kind(f)}"];`).join(" ")} ${edges.join(" ")} ${more} }`;
}

export function Graph({ dot, label, go, target }: { dot: string; label: string; go: (target: Target) => void; target: (classes: DOMTokenList) => Target | null }) {
  const box = useRef<HTMLDivElement>(null);
  const zoomer = useRef<ZoomBehavior<SVGSVGElement, unknown> | null>(null);
  const [state, setState] = useState("Drawing…");
  useEffect(() => {
    let current = true;
    graphviz().then((engine) => {
      if (!current || !box.current) return;
      const svg = cleaned(engine.renderString(dot, { format: "svg" }));
      svg.setAttribute("width", "100%");
      svg.setAttribute("height", "100%");
      svg.setAttribute("role", "group");
      svg.setAttribute("aria-label", label);
      const view = document.createElementNS("http://www.w3.org/2000/svg", "g");
      view.append(...svg.childNodes);
      svg.append(view);
      for (const title of svg.querySelectorAll(":scope > g > g.graph > title, g.edge > title, g.cluster > title")) title.remove();
      for (const node of svg.querySelectorAll<SVGGElement>("g.node")) {
        node.querySelector(":scope > title")?.remove();
        const leads = target(node.classList);
        const words = [...node.querySelectorAll("text")].map((t) => t.textContent).join(" ");
        if (!leads) continue;
        node.setAttribute("role", "link");
        node.setAttribute("tabindex", "0");
        node.setAttribute("aria-label", words);
        node.addEventListener("click", () => go(leads));
        node.addEventListener("keydown", (event) => { if (event.key === "Enter") go(leads); });
      }
      box.current.replaceChildren(svg);
      const made = zoom<SVGSVGElement, unknown>().scaleExtent([0.2, 12]).on("zoom", ({ transform }) => view.setAttribute("transform", transform.toString()));
      select(svg).call(made);
      zoomer.current = made;
      setState("");
    }, (problem) => current && setState(`It could not be drawn: ${problem}`));
    return () => { current = false; };
  }, [dot]);
  const turn = (action: (svg: ReturnType<typeof select<SVGSVGElement, unknown>>, zoomer: ZoomBehavior<SVGSVGElement, unknown>) => void) => {
    const svg = box.current?.querySelector("svg");
    if (svg && zoomer.current) action(select<SVGSVGElement, unknown>(svg), zoomer.current);
  };
  const larger = () => turn((svg, z) => z.scaleBy(svg, 1.4));
  const smaller = () => turn((svg, z) => z.scaleBy(svg, 1 / 1.4));
  const whole = () => turn((svg, z) => z.transform(svg, zoomIdentity));
  const keys = (event: KeyboardEvent) => {
    const actions: Record<string, () => void> = {
      "+": larger, "-": smaller, "0": whole,
      ArrowLeft: () => turn((svg, z) => z.translateBy(svg, 40, 0)), ArrowRight: () => turn((svg, z) => z.translateBy(svg, -40, 0)),
      ArrowUp: () => turn((svg, z) => z.translateBy(svg, 0, 40)), ArrowDown: () => turn((svg, z) => z.translateBy(svg, 0, -40)),
    };
    if (!actions[event.key]) return;
    event.preventDefault();
    actions[event.key]();
  };
  return (
    <div class="graph" onKeyDown={keys}>
      <div class="tools"><button type="button" onClick={larger} aria-label="larger">+</button><button type="button" onClick={smaller} aria-label="smaller">−</button><button type="button" onClick={whole}>whole</button></div>
      {state && <p role="status">{state}</p>}
      <div class="drawing" ref={box} tabIndex={0} role="region" aria-label={`${label}; plus and minus change the size, arrows move it`} />
    </div>
  );
}
