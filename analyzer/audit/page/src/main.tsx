// The frame: reads the index, shows the view that the address names, and what is the same in all of them.
import { render } from "preact";
import { useEffect, useState } from "preact/hooks";
import { readIndex } from "./data";
import { Findings } from "./findings";
import { Model } from "./model";
import { Overview } from "./overview";
import { ProgramView } from "./program";
import { Programs } from "./programs";
import { link, useRoute } from "./route";
import { RulePage } from "./rule";
import { visible } from "./words";

function remembered(): string {
  try { return localStorage.getItem("owlint-theme") ?? ""; } catch { return ""; }
}

function useTheme(): [boolean, () => void] {
  const [theme, set] = useState(remembered);
  const dark = theme === "" ? matchMedia("(prefers-color-scheme: dark)").matches : theme === "dark";
  useEffect(() => { document.documentElement.dataset.theme = dark ? "dark" : "light"; }, [dark]);
  return [dark, () => {
    const next = dark ? "light" : "dark";
    set(next);
    try { localStorage.setItem("owlint-theme", next); } catch { /* a page without storage forgets it */ }
  }];
}

const titles: Record<string, string> = { "": "overview", findings: "findings", programs: "programs", program: "program", rule: "rule" };

function App({ model }: { model: Model }) {
  const route = useRoute();
  const [dark, turn] = useTheme();
  useEffect(() => {
    const name = route.name === "program" ? visible(model.shown[Number(route.id)] ?? "").slice(-80) : route.name === "rule" ? route.id : (titles[route.name] ?? "overview");
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
          : route.name === "rule" ? <><h1>{route.id}</h1><RulePage model={model} code={route.id} /></>
          : <Overview model={model} folder={route.query.get("folder") ?? ""} />}
      </main>
      <footer>Made by owlint {model.index.tool.version}, {model.index.made.replace("T", " ").replace("Z", " UTC")}. Libraries in this page: Preact, TanStack Virtual, Viz.js with Graphviz, d3-zoom, marked.</footer>
    </>
  );
}

async function start() {
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
