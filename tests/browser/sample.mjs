// Made-up data of the page, as many as are wanted: a shop of 100,000 programs is too large to audit in a test.
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { repository } from "./browser.mjs";

const template = process.env.PAGE ?? join(repository, "build", "release", "page", "page.html");

/** The same numbers each time. */
function random(seed) {
  let state = seed >>> 0;
  return (below) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * below);
  };
}

const element = (id, data) => `<script type="text/plain" id="${id}">${gzipSync(JSON.stringify(data)).toString("base64")}</script>\n`;

/** The page of a shop; the details of every 20th program are in it. */
export function samplePage(programs, findings) {
  const next = random(7);
  const codes = ["OW101", "OW104", "OW106", "OW204", "OW205", "OW207", "OW301", "OW304", "OW508", "OW603"];
  const index = {
    schema: "owlint-page-2", tool: { name: "owlint", version: "0.0.0" }, made: "2026-01-02T03:04:05Z", roots: ["nc"],
    runs: Array.from({ length: 40 }, (_, i) => ({ id: i + 1, started: "2026-01-02T03:04:05Z", seconds: 9, version: "0.0.0", files: programs, checked: i * 3, errors: findings - i * 100, warnings: next(900), infos: 0, new: next(9), gone: next(9) })),
    rules: codes.map((code) => ({ code, name: `rule-${code}`, summary: "what it `finds`", markdown: `# ${code}\n\nText with **weight** and \`code\`.\n\n- one\n- two` })),
    files: { path: [], kind: [], lines: [], bytes: [], part: [], problem: [] },
    findings: { file: [], rule: [], severity: [], line: [], column: [], message: [], fix: [], isNew: [] },
    gone: { path: [], rule: [], severity: [], line: [], message: [] },
    calls: { from: [], to: [] },
  };
  for (let f = 0; f < programs; ++f) {
    index.files.path.push(`customer${String(f % 211).padStart(3, "0")}/job${f % 1009}/part${f}.ngc`);
    index.files.kind.push(0);
    index.files.lines.push(20 + next(5000));
    index.files.bytes.push(1000 + next(90000));
    index.files.part.push(f % 20 === 0 ? 0 : -1);
    index.files.problem.push("");
    if (f % 10 === 0) { index.calls.from.push(f); index.calls.to.push(f % 97); }
  }
  index.files.path.sort();
  const per = findings / programs;
  for (let f = 0, made = 0; f < programs && made < findings; ++f) {
    while (made < (f + 1) * per) {
      const rule = next(codes.length);
      index.findings.file.push(f);
      index.findings.rule.push(rule);
      index.findings.severity.push(1 + next(2));
      index.findings.line.push(1 + next(20));
      index.findings.column.push(1);
      index.findings.message.push(`label \`o${next(900)}\` is already used for an \`if\` on line ${next(40)}`);
      index.findings.fix.push(made % 3);
      index.findings.isNew.push(next(1000) === 0 ? 1 : 0);
      ++made;
    }
  }
  const part = {};
  for (let f = 0; f < programs; f += 20) part[f] = { lineCount: 3, source: [[1, ["o100 if [1]", "G1 X1", "o100 endif"]]], findings: [], modes: null, blocks: null };
  const [before, after] = readFileSync(template, "utf8").split("<!--owlint:data-->");
  const file = join(mkdtempSync(join(tmpdir(), "owlint-page-")), "sample.html");
  writeFileSync(file, before + element("owlint-part-0", part) + element("owlint-index", index) + after);
  return file;
}
