// Lines of words: completion of codes, and hover over codes and letter words.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { markup, session } from './client.mjs';
import { offered } from './offered.mjs';
import * as places from './places.mjs';
import { files } from './shop.mjs';

const machine = {
  'machine.ini': `[RS274NGC]
REMAP = M6 modalgroup=6 ngc=change
REMAP = M400 modalgroup=10 python=lock
REMAP = G88.1 ngc=measure
REMAP = M3 ngc=never
REMAP = T python=Choose
USER_M_PATH = codes
[DISPLAY]
PROGRAM_PREFIX = nc
[TRAJ]
COORDINATES = X Z
`,
  'nc/part.ngc': 'G1 X1 F100\nG88.1 X1\nM6 T1\nM400 P1\nM3 S100\nM101 P2\nM102\nG0 Y1\nM2\n',
};

/** The machine with its program M101. */
function withUserCode(client) {
  client.writeFile('codes/M101', '#!/bin/sh\n');
  fs.chmodSync(path.join(client.folder, 'codes/M101'), 0o755);
}

session('completion: codes where a word may begin', { files }, async (client) => {
  const g = await offered(client, 'G21 G90\nG0 X1 G‸\nM2\n');
  const labels = g.map((item) => item.label);
  for (const label of ['G1', 'G17', 'G38.2', 'G91.1']) assert.ok(labels.includes(label), label);
  assert.ok(labels.indexOf('G2') < labels.indexOf('G10'), 'by number');
  assert.ok(labels.every((label) => label.startsWith('G')));
  assert.ok(!labels.includes('G6.2'), 'a code of a later release');
  const arc = g.find((item) => item.label === 'G2');
  assert.equal(arc.detail, 'clockwise arc or helix');
  assert.match(arc.documentation.value, /takes: axes, I, J, K, R, P/);
  assert.equal(arc.line, 'G0 X1 G2');
  const m = (await offered(client, 'G21 G90\nN10 m‸\nM2\n')).map((item) => item.line);
  for (const line of ['N10 m3', 'N10 m98']) assert.ok(m.includes(line), line);
  assert.ok(!m.includes('N10 m100'), 'no machine is known');
  assert.ok((await offered(client, 'G0 M‸')).every((item) => item.label !== 'M98'), 'only as the first word');
  assert.deepEqual((await offered(client, '/ g38.‸4 X1')).map((item) => item.line).slice(0, 2), ['/ g38.2 X1', '/ g38.3 X1']);
  for (const line of ['(G‸', '; G‸', '(a G‸)', '#<G‸', 'G1 X[G‸', 'G1 X[1] #<a>=G‸', 'o100 if [#1 EQ 1] G‸', 'G1 XG‸', 'G ‸', 'M98 P1 M‸', 'X1G1X‸'])
    assert.deepEqual(await offered(client, `${line}\nM2\n`), [], line);
});

session('completion: codes of the machine', { files: machine }, async (client) => {
  withUserCode(client);
  const at = (line) => offered(client, `${line}\nM2\n`, 'nc/draft.ngc');
  const details = Object.fromEntries([...(await at('G‸')), ...(await at('M‸'))].map((item) => [item.label, item.detail]));
  assert.equal(details['G88.1'], 'calls `o<measure>`');
  assert.equal(details.M6, 'calls `o<change>`');
  assert.equal(details.M400, 'calls the Python function `lock`');
  assert.equal(details.M3, 'spindle on, clockwise');
  assert.equal(details.M101, 'run a program of the machine\'s own');
  assert.ok(!('M102' in details));
});

session('hover over words', { files: machine }, async (client) => {
  withUserCode(client);
  const part = 'nc/part.ngc';
  client.open(part);
  const whole = async (piece, into = 0) => {
    const place = client.params(part, piece, into);
    const result = await client.request('textDocument/hover', place);
    if (result) assert.ok(places.contains(result.range, { start: place.position, end: place.position }), piece);
    return result && markup(result.contents);
  };
  const modes = '\n\nBefore this line:\n\n';
  const hover = async (piece, into = 0) => (await whole(piece, into))?.split(modes)[0] ?? null;
  assert.ok((await whole('G88.1')).endsWith(`${modes}- motion mode: G1, line 1\n- feed: set, line 1`));
  assert.equal(await hover('G1 X1'), '**G1** straight move at feed rate\n\n- group: motion\n- takes: axes X Z');
  assert.equal(await hover('G88.1'), '**G88.1** code of this machine\n\n`REMAP` on line 4 of machine.ini: on this machine it calls `o<measure>`.');
  assert.match(await hover('M6'), /^\*\*M6\*\* change the tool\n\n- group: tool change\n\n`REMAP` on line 2 of machine\.ini: on this machine it calls `o<change>`\.$/);
  assert.match(await hover('T1', 1), /^\*\*T\*\* tool to prepare[^]*on this machine it calls the Python function `Choose`\.$/);
  assert.doesNotMatch(await hover('M3 S'), /REMAP/);
  assert.match(await hover('M101'), /`M101` runs a program of the machine named `M101`, and this machine has it\./);
  assert.match(await hover('M102'), /and this machine has none\./);
  assert.match(await hover('Y1'), /This machine has no such axis\./);
  client.replaceAll(part, 'G33 Z1 K1\nG6.2 X1\nG4 P1\n(G1)\nG777 G12\nG0 X[#1] G[#1]\nM98 P100 L2\n%\n');
  assert.match(await hover('G33'), /needs: an axis, K\n- takes: axes X Z, E, K, \$\n- refuses: F$/);
  const pitch = await hover('K1', 2);
  assert.match(pitch, /^\*\*K\*\* arc center in Z; pitch of a thread; its full depth\n\n- number: real\n- taken by: G2, G3, G33/);
  assert.match(pitch, /needed by: G33, G33\.1 and G76\n- on this line for: G33\n- twice on a line: stops$/);
  assert.match(await hover('G6.2'), /since LinuxCNC 2\.10\n- the program is checked for LinuxCNC 2\.9, which does not have it$/);
  assert.match(await hover('G4'), /not modal: it acts once\n- needs: P\n/);
  assert.match(await hover('X['), /taken by: motions; G10, G28/);
  assert.match(await hover('G[#1]'), /^\*\*G\*\* preparatory code/);
  for (const piece of ['(G1', 'G777', 'G12', 'L2', '%']) assert.equal(await hover(piece, 1), null, piece);
  assert.match(await hover('M98'), /call a sub, as on Fanuc controllers/);
});
