// One program: its lines with what is wrong with them, the rule beside it, its drawings, and who calls it.
import { useEffect, useMemo, useState } from "preact/hooks";
import { readDetails, type Details } from "./data";
import { callGraph, Graph } from "./graph";
import type { Model } from "./model";
import { plural } from "./model";
import { link, type Route } from "./route";
import { RulePage } from "./rule";
import { SourceView } from "./source";
import { Path } from "./words";

function Files({ model, title, files }: { model: Model; title: string; files: number[] }) {
  if (files.length === 0) return null;
  const shown = files.slice(0, 100);
  return <details open={files.length < 6}><summary>{title} {plural(files.length, "program")}</summary><ul class="plain">{shown.map((f) => <li key={f}><a href={link("program", f)}><Path path={model.shown[f]} /></a></li>)}</ul>{files.length > shown.length && <p>and {files.length - shown.length} more</p>}</details>;
}

export function ProgramView({ model, route }: { model: Model; route: Route }) {
  const file = Number(route.id);
  if (!Number.isInteger(file) || model.shown[file] === undefined) return <><h1>Program</h1><p class="empty">There is no such program in this audit.</p></>;
  return <Known key={file} model={model} route={route} file={file} />;
}

function Known({ model, route, file }: { model: Model; route: Route; file: number }) {
  const line = Number(route.query.get("line") ?? 0);
  const tab = route.query.get("view") ?? "lines";
  const [details, setDetails] = useState<Details | null | undefined>(undefined);
  const [code, setCode] = useState("");
  useEffect(() => {
    setDetails(undefined);
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
  const calls = useMemo(() => callGraph(model, file), [file]);
  const { lines, problem } = model.index.files;
  const hasCalls = model.calls(file).length + model.callers(file).length > 0;
  const lineOf = (classes: DOMTokenList) => Number([...classes].find((c) => /^line-\d+$/.test(c))?.slice(5) ?? 0);
  const inBlocks = (classes: DOMTokenList) => {
    const other = [...classes].find((c) => /^file-\d+$/.test(c));
    const target = other ? model.fileOf(details!.graphFiles[Number(other.slice(5))]) : file;
    return target !== undefined && lineOf(classes) > 0 ? { file: target, line: lineOf(classes) } : null;
  };
  const inCalls = (classes: DOMTokenList) => {
    const target = [...classes].find((c) => /^goto-\d+$/.test(c));
    return target ? { file: Number(target.slice(5)), line: 0 } : null;
  };
  const go = (to: { file: number; line: number }) => { location.hash = link("program", to.file, { line: to.line > 0 ? String(to.line) : undefined }); };
  const tabs: [string, string, boolean][] = [["lines", "Lines", true], ["blocks", "Blocks", Boolean(details?.graph)], ["calls", "Calls", hasCalls]];
  return (
    <>
      <h1 class="program-name"><Path path={model.shown[file]} /></h1>
      <p class="when">{plural(lines[file], "line")}, {plural(model.counts[2][file], "error")}, {plural(model.counts[1][file], "warning")}{problem[file] && <>: cannot be read: {problem[file]}</>}</p>
      <nav class="tabs" aria-label="views of the program">{tabs.map(([name, words, there]) => there && <a key={name} href={link("program", file, { view: name === "lines" ? undefined : name })} aria-current={tab === name ? "page" : undefined}>{words}</a>)}</nav>
      <div class="program">
        <div class="main">
          {details === undefined && <p role="status">Reading…</p>}
          {details === null && <p class="empty">The lines of this program are not in this page, so that it stays small. Nothing was found in it.</p>}
          {details && tab === "lines" && (details.source.length > 0 ? <SourceView model={model} file={file} details={details} line={line} open={setCode} /> : <p class="empty">The program has changed since, or is empty.</p>)}
          {details?.graph && tab === "blocks" && <Graph key={`b${file}`} dot={details.graph} label="blocks of the program" go={go} target={inBlocks} />}
          {tab === "calls" && hasCalls && <Graph key={`c${file}`} dot={calls} label="programs that call this one, and that it calls" go={go} target={inCalls} />}
        </div>
        <aside aria-label="about this program">
          <Files model={model} title="Called by" files={model.callers(file)} />
          <Files model={model} title="Calls" files={model.calls(file)} />
          {code && <RulePage model={model} code={code} />}
        </aside>
      </div>
    </>
  );
}
