// The frame: reads the index, shows the view that the address names, and what is the same in all of them.
import { render } from "preact";
import { useEffect, useLayoutEffect, useState } from "preact/hooks";
import { readIndex } from "./data";
import { Findings } from "./findings";
import { Model } from "./model";
import { Overview } from "./overview";
import { ProgramView } from "./program";
import { Programs } from "./programs";
import { link, useRoute } from "./route";
import { RulePage } from "./rule";
import { visible } from "./words";

/** What the reader chose last, or else what the system says. */
function prefersDark(): boolean {
  let chosen = "";
  try { chosen = localStorage.getItem("owlint-theme") ?? ""; } catch { /* a page without storage asks the system */ }
  return chosen === "" ? matchMedia("(prefers-color-scheme: dark)").matches : chosen === "dark";
}

function paint(dark: boolean) {
  document.documentElement.dataset.theme = dark ? "dark" : "light";
}

function useTheme(): [boolean, () => void] {
  const [dark, set] = useState(prefersDark);
  // Before the browser paints: otherwise one frame has the button of one theme and the colours of the other.
  useLayoutEffect(() => paint(dark), [dark]);
  return [dark, () => {
    set(!dark);
    try { localStorage.setItem("owlint-theme", dark ? "light" : "dark"); } catch { /* a page without storage forgets it */ }
  }];
}

const titles: Record<string, string> = { "": "overview", findings: "findings", programs: "programs", program: "program", rule: "rule" };

function App({ model }: { model: Model }) {
  const route = useRoute();
  const [dark, turn] = useTheme();
  useEffect(() => {
    const name = route.name === "program" ? visible(model.paths[Number(route.id)] ?? "").slice(-80) : route.name === "rule" ? route.id : (titles[route.name] ?? "overview");
    document.title = `${name} · owlint audit`;
  }, [route]);
  useEffect(() => {
    const keys = (event: KeyboardEvent) => {
      const typing = /^(INPUT|SELECT|TEXTAREA)$/.test((event.target as Element).tagName);
      if (event.key === "/" && !typing) {
        event.preventDefault();
        const search = document.getElementById("search");
        search ? search.focus() : (location.hash = link("findings"));
      } else if (event.key === "Escape" && typing) {
        (event.target as HTMLElement).blur();
      }
    };
    addEventListener("keydown", keys);
    return () => removeEventListener("keydown", keys);
  }, []);
  const tab = (name: string, words: string) => <a href={link(name)} aria-current={route.name === name ? "page" : undefined}>{words}</a>;
  return (
    <>
      <a class="skip" href="#main" onClick={(e) => { e.preventDefault(); document.getElementById("main")?.focus(); }}>Skip to the content</a>
      <header class="top">
        <a class="brand" href={link("")}>owlint <span>audit</span></a>
        <nav aria-label="views">{tab("", "Overview")}{tab("findings", "Findings")}{tab("programs", "Programs")}</nav>
        <button type="button" onClick={turn} aria-label={dark ? "light colours" : "dark colours"}>{dark ? "☀" : "☾"}</button>
      </header>
      <main id="main" tabIndex={-1}>
        {route.name === "findings" ? <Findings model={model} route={route} />
          : route.name === "programs" ? <Programs model={model} route={route} />
          : route.name === "program" ? <ProgramView model={model} route={route} />
          : route.name === "rule" ? <RulePage model={model} code={route.id} top={1} />
          : <Overview model={model} folder={route.query.get("folder") ?? ""} />}
      </main>
      <footer>Made by owlint {model.index.tool.version}, {model.index.made.replace("T", " ").replace("Z", " UTC")}. Libraries in this page: Preact, TanStack Virtual, Viz.js with Graphviz, Shiki’s vscode-textmate, marked.</footer>
    </>
  );
}

async function start() {
  paint(prefersDark());  // a large index takes a while to read, and nobody wants to wait in front of a white page at night
  const root = document.getElementById("app")!;
  try {
    const model = new Model(await readIndex());
    root.replaceChildren();
    render(<App model={model} />, root);
    root.dataset.ready = "true";
  } catch (problem) {
    root.querySelector("[role=status]")!.textContent = `The audit cannot be shown: ${problem}`;
  }
}

document.readyState === "loading" ? addEventListener("DOMContentLoaded", start) : start();
