// One program: its lines with what is wrong with them, the rule beside it, its drawings, and who calls it.
import { useEffect, useState } from "preact/hooks";
import { BlocksView } from "./blocks";
import { CallsView } from "./calls";
import { machine, readDetails, type Details } from "./data";
import { ExtentsTable } from "./extents";
import type { Model } from "./model";
import { number, plural } from "./model";
import { ModesPanel } from "./modes";
import { useNarrow } from "./narrow";
import { link, type Route } from "./route";
import { RulePage } from "./rule";
import { level, SourceView } from "./source";
import { Badge, Message, Path, visible, WholePath } from "./words";

function Files({ model, title, files }: { model: Model; title: string; files: number[] }) {
  if (files.length === 0) return null;
  const shown = files.slice(0, 100);
  return <details open={files.length < 6}><summary>{title} {plural(files.length, "program")}</summary><ul class="plain">{shown.map((f) => <li key={f}><a href={link("program", f)}><Path path={model.paths[f]} /></a></li>)}</ul>{files.length > shown.length && <p>and {files.length - shown.length} more</p>}</details>;
}

/** All findings of the program, the worst first: in a long program they are far from each other. */
function Contents({ file, details, line }: { file: number; details: Details; line: number }) {
  const found = [...details.findings].sort((a, b) => level(b) - level(a) || a.start.offset - b.start.offset);
  if (found.length === 0) return null;
  return (
    <nav class="contents" aria-label="findings of the program" tabIndex={0}>
      <ul class="plain">{found.map((f, i) => (
        <li key={i}><a href={link("program", file, { line: String(f.start.line) })} aria-current={f.start.line === line ? "true" : undefined}><Badge severity={level(f)} /> <span class="number">{f.start.line}</span> <span class="words"><Message text={f.message} /></span></a></li>
      ))}</ul>
    </nav>
  );
}

export function ProgramView({ model, route }: { model: Model; route: Route }) {
  const file = Number(route.id);
  if (!Number.isInteger(file) || model.paths[file] === undefined) return <><h1>Program</h1><p class="empty">There is no such program in this audit.</p></>;
  return <Known key={file} model={model} route={route} file={file} />;
}

function Known({ model, route, file }: { model: Model; route: Route; file: number }) {
  const line = Number(route.query.get("line") ?? 0);
  const narrow = useNarrow();
  const [details, setDetails] = useState<Details | null | undefined>(undefined);
  const [code, setCode] = useState("");
  useEffect(() => {
    readDetails(model.index, file).then((read) => {
      setDetails(read);
      const at = read?.findings.find((f) => f.start.line === line) ?? read?.findings[0];
      setCode(at?.code ?? "");
    });
  }, [file]);
  useEffect(() => {
    const at = details?.findings.find((f) => f.start.line === line);
    if (at) setCode(at.code);
  }, [line]);
  // Beside the lines there is room for the rule; on a phone its page is opened, as the link says.
  const open = (event: MouseEvent, code: string) => {
    if (narrow || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    setCode(code);
  };
  const { lines, problem, kind } = model.index.files;
  const hasCalls = model.calls(file).length + model.callers(file).length > 0;
  // The address names the view; the lines are shown where the program has no such view.
  const tabs = [["lines", "Lines"], ...(details?.blocks ? [["blocks", "Blocks"]] : []), ...(hasCalls ? [["calls", "Calls"]] : [])];
  const tab = tabs.find(([name]) => name === route.query.get("view"))?.[0] ?? "lines";
  const path = model.paths[file];
  const slash = path.lastIndexOf("/") + 1;
  const [infos, warnings, errors] = model.counts.map((counts) => counts[file]);
  return (
    <>
      <p class="place"><WholePath path={path.slice(0, slash)} /></p>
      <h1 class="program-name"><WholePath path={path.slice(slash)} /></h1>
      <p class="when">{plural(lines[file], "line")}, {plural(errors, "error")}, {plural(warnings, "warning")}{infos > 0 && `, ${number(infos)} info`}{problem[file] && <>; cannot be read: {visible(problem[file])}</>}</p>
      {details && <Contents file={file} details={details} line={line} />}
      {tabs.length > 1 && <nav class="tabs" aria-label="views of the program">{tabs.map(([name, words]) => <a key={name} href={link("program", file, { view: name === "lines" ? undefined : name })} aria-current={tab === name ? "page" : undefined}>{words}</a>)}</nav>}
      <div class={tab === "lines" ? "program" : "program drawn"}>
        <div class="main">
          {details === undefined && <p role="status">Reading…</p>}
          {details === null && <p class="empty">The lines of this program are not in this page, so that it stays small. Nothing was found in it.</p>}
          {details && tab === "lines" && (details.source.length > 0 ? <SourceView file={file} details={details} language={kind[file] === machine ? "machine" : "program"} line={line} open={open} /> : <p class="empty">The program is empty, or has changed since the audit.</p>)}
          {details?.blocks && tab === "blocks" && <BlocksView model={model} file={file} details={{ ...details, blocks: details.blocks }} />}
          {tab === "calls" && hasCalls && <CallsView model={model} file={file} />}
        </div>
        <aside aria-label="about this program">
          {details?.modes && !narrow && tab === "lines" && <ModesPanel file={file} modes={details.modes} line={line} />}
          {details?.extents && <ExtentsTable extents={details.extents} />}
          <Files model={model} title="Called by" files={model.callers(file)} />
          <Files model={model} title="Calls" files={model.calls(file)} />
          {code && !narrow && tab === "lines" && <RulePage model={model} code={code} />}
        </aside>
      </div>
    </>
  );
}
