// Replays typing and tells how long it takes from a keystroke to its diagnostics.
//
// usage: node typing.mjs OWLINT [PROGRAM...]
//
// In a program of 10,000 lines with O-words and in a CAM program of 1,000,000 lines, or in the middle of PROGRAMs, a word is typed and
// deleted again, one character at a time; each time the diagnostics for that very version are waited for. A figure, not a test.
import { spawn } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { performance } from 'node:perf_hooks';
import process from 'node:process';
import { pathToFileURL } from 'node:url';
import { createMessageConnection, StreamMessageReader, StreamMessageWriter } from 'vscode-jsonrpc/node.js';

const owlint = process.argv[2];

function oWords(lines) {
  const out = [];
  for (let part = 0; out.length < lines; ++part) {
    out.push(`o<part${part}> sub`, '  #<left> = #1');
    for (let r = 0; r < 6; ++r) {
      const k = 100 + 10 * r;
      out.push(`  o${k} if [#2 GT ${r}]`, '    G1 X12.5 Y3', `  o${k} elseif [#2 LT -${r + 1}]`, '    G1 X1', `  o${k} else`, '    G1 Y1', `  o${k} endif`,
        `  o${k + 1} while [#<left> GT ${r}.5]`, '    G1 Z-1', `    o${k + 2} if [#<left> EQ #3]`, `      o${k + 1} break`, `    o${k + 2} endif`,
        '    #<left> = [#<left> - 1]', `  o${k + 1} endwhile`, `  o${k + 3} repeat [#4]`, '    G1 X0', `  o${k + 3} endrepeat`);
    }
    out.push(`o<part${part}> endsub`, `o<part${part}> call [5] [#500] [2] [2]`);
  }
  return [...out.slice(0, lines - 1), 'M2', ''].join('\n');
}

function motion(lines) {
  const out = [];
  for (let i = 0; i < lines; ++i) out.push(`X${(i * 0.137) % 300} Y${(i * 0.071) % 200} Z-1.25`);
  return ['G21 G90 F800', ...out, 'o100 if [#500 GT 0]', 'G0 Z5', 'o100 endif', 'M2', ''].join('\n');
}

async function replay(name, text, line, keys, uri = 'file:///typing/program.ngc') {
  const server = spawn(owlint, ['lsp'], { stdio: ['pipe', 'pipe', 'inherit'] });
  const connection = createMessageConnection(new StreamMessageReader(server.stdout), new StreamMessageWriter(server.stdin));
  let wanted = -1;
  let arrived = () => {};
  connection.onNotification('textDocument/publishDiagnostics', (params) => params.version === wanted && arrived());
  connection.listen();
  await connection.sendRequest('initialize', { processId: null, rootUri: null, capabilities: { general: { positionEncodings: ['utf-8'] } } });
  await connection.sendNotification('initialized', {});
  const answered = (version) => new Promise((resolve) => { wanted = version; arrived = resolve; });
  let done = answered(0);
  await connection.sendNotification('textDocument/didOpen', { textDocument: { uri, languageId: 'linuxcnc', version: 0, text } });
  await done;
  const times = [];
  let version = 0;
  const type = async (range, inserted) => {
    done = answered(++version);
    const started = performance.now();
    await connection.sendNotification('textDocument/didChange', { textDocument: { uri, version }, contentChanges: [{ range, text: inserted }] });
    await done;
    times.push(performance.now() - started);
  };
  for (let round = 0; round < 10; ++round) {
    for (let i = 0; i < keys.length; ++i) await type({ start: { line, character: i }, end: { line, character: i } }, keys[i]);
    for (let i = keys.length; i > 0; --i) await type({ start: { line, character: i - 1 }, end: { line, character: i } }, '');
  }
  await connection.sendRequest('shutdown');
  await connection.sendNotification('exit');
  times.sort((a, b) => a - b);
  const at = (share) => times[Math.min(times.length - 1, Math.floor(times.length * share))].toFixed(1);
  console.log(`${name}: ${times.length} keystrokes, median ${at(0.5)} ms, p99 ${at(0.99)} ms, longest ${at(1)} ms`);
  connection.dispose();
}

const programs = process.argv.slice(3);
for (const program of programs) {
  const text = fs.readFileSync(program, 'utf8');
  await replay(path.basename(program), text, Math.floor(text.split('\n').length / 2), 'G1 X5 (stop)', pathToFileURL(path.resolve(program)).href);
}
if (programs.length === 0) {
  await replay('10,000 lines of O-words', oWords(10_000), 4_000, 'o900 if [#1 GT 5]');
  await replay('1,000,000 lines of motion', motion(1_000_000), 500_000, 'G1 X5 (stop)');
}
