// A machine's INI in the editor: its findings while it is typed, what keys mean, and the way to the subs that it names.
import assert from 'node:assert/strict';
import { codes, locations, markup, session } from './client.mjs';
import { offered } from './offered.mjs';

const ini = `[EMC]
VERSION = 1.1
[DISPLAY]
DISPLAY = axis
PROGRAM_PREFIX = nc
NGCGUI_SUBFILE = slot.ngc
[RS274NGC]
SUBROUTINE_PATH = subs
PARAMETER_FILE = linuxcnc.var
REMAP = M400 modalgroup=10 argspec=p ngc=clamp
OWORD_NARGS = YES
[MACROS]
MACRO = measure diameter depth
[HALUI]
MDI_COMMAND = G0 Z0
MDI_COMMAND = o<measure> call [1]
[EMCIO]
TOOL_TABLE = tool.tbl
[TRAJ]
LINEAR_UNITS = mm
ANGULAR_UNITS = degree
[KINS]
KINEMATICS = trivkins
JOINTS = 3
`;
const sub = (name) => `(${name}: what it does)\no<${name}> sub\n  G0 X#1\no<${name}> endsub\nM2\n`;
const files = {
  'machine.ini': ini,
  'subs/clamp.ngc': 'o<clamp> sub\n  G0 X[#<p>]\no<clamp> endsub\nM2\n',
  'subs/measure.ngc': sub('measure'),
  'subs/slot.ngc': sub('slot'),
  'nc/part.ngc': 'G21 G90\no<measure> call [3]\nM400 P1\nM2\n',
  'linuxcnc.var': '5161 0\n',
  'tool.tbl': 'T1 P1 D3\n',
  'other.ini': '[fonts]\nno equals here\n',
};
const name = 'machine.ini';

session('findings in an INI, pulled, with their fix', { files }, async (client) => {
  client.open(name);
  const found = await client.pulled(name);
  assert.deepEqual(codes(found), ['OW415']);
  assert.deepEqual(found[0].range, client.range(name, 'YES'));
  const actions = await client.request('textDocument/codeAction', client.document(name, { range: found[0].range, context: { diagnostics: found } }));
  const fix = actions.find((one) => one.isPreferred);
  const after = client.afterEdit(fix.edit)[name];
  assert.match(after, /^OWORD_NARGS = 1$/m);
  client.replaceAll(name, after);
  assert.deepEqual(await client.pulled(name), []);
  client.replace(name, ['LINEAR_UNITS = mm', 'LINEAR_UNITS = mm # metric']);
  assert.deepEqual(codes(await client.pulled(name)), ['OW415']);
});

session('a suppression is a comment of the INI', { files }, async (client) => {
  client.open(name);
  const found = await client.pulled(name);
  const actions = await client.request('textDocument/codeAction', client.document(name, { range: found[0].range, context: { diagnostics: found } }));
  client.replaceAll(name, client.afterEdit(actions.find((one) => one.title.startsWith('suppress')).edit)[name]);
  assert.deepEqual(await client.pulled(name), []);
});

session('programs are checked again as their INI is typed', { files, pull: false }, async (client) => {
  client.open('nc/part.ngc');
  await client.waitDiagnostics('nc/part.ngc', 1, (found) => found.length === 0);
  client.open(name);
  await client.waitDiagnostics(name, 1, (found) => codes(found).includes('OW415'));
  const seen = client.published.length;
  client.replace(name, ['SUBROUTINE_PATH = subs', 'SUBROUTINE_PATH = none']);
  await client.waitDiagnostics('nc/part.ngc', 1, (found) => codes(found).includes('OW208'), seen);
  const again = client.published.length;
  client.replace(name, ['SUBROUTINE_PATH = none', 'SUBROUTINE_PATH = subs']);
  await client.waitDiagnostics('nc/part.ngc', 1, (found) => found.length === 0, again);
  client.closeDocument(name);
});

session('an INI of another program has no findings, and one of the workspace has its own', { files }, async (client) => {
  client.open('other.ini');
  assert.deepEqual(await client.pulled('other.ini'), []);
  const report = await client.request('workspace/diagnostic', { previousResultIds: [] });
  const items = Object.fromEntries(report.items.map((one) => [client.name(one.uri), codes(one.items)]));
  assert.deepEqual(items[name], ['OW415']);
  assert.ok(!('other.ini' in items));
});

session('hover: sections, keys, and what values name', { files }, async (client) => {
  client.open(name);
  const hover = async (piece, into = 0) => markup((await client.request('textDocument/hover', client.params(name, piece, into)))?.contents);
  assert.match(await hover('[TRAJ]', 2), /\*\*\[TRAJ\]\*\* units, axes/);
  assert.match(await hover('LINEAR_UNITS', 3), /unit of lengths[^]*`mm`[^]*LinuxCNC ends/);
  assert.match(await hover('OWORD_NARGS', 3), /`0` or `1`/);
  assert.match(await hover('ngc=clamp', 5), /`o<clamp>` is in .*clamp\.ngc`, line 1/);
  assert.match(await hover('o<measure>', 4), /measure\.ngc`, line 2[^]*what it does/);
  assert.match(await hover('tool.tbl', 2), /The file `.*tool\.tbl`/);
  assert.equal(await hover('[MACROS]', 2), '', 'a section of displays');
  assert.equal(await hover('= axis', 0), '');
});

session('completion: sections, keys, values, subs', { files }, async (client) => {
  const at = async (text) => (await offered(client, text, 'subs/../draft.ini')).map((item) => item.line);
  const head = '[EMC]\nVERSION = 1.1\n';
  const sections = await at(`${head}[‸`);
  for (const line of ['[TRAJ]', '[AXIS_X]', '[JOINT_0]', '[JOINT_2]']) assert.ok(sections.includes(line), line);
  assert.ok(!sections.includes('[EMC]'), 'it is there');
  assert.deepEqual((await at(`${head}[TR‸]`)), ['[TRAJ]']);
  const keys = await at(`${head}[TRAJ]\nLINEAR_UNITS = mm\n‸`);
  assert.ok(keys.includes('ANGULAR_UNITS = ') && !keys.includes('LINEAR_UNITS = '));
  assert.deepEqual(await at(`${head}[TRAJ]\nLINEAR_U‸ = mm\n`), ['LINEAR_UNITS = mm']);
  assert.deepEqual((await at(`${head}[TRAJ]\nLINEAR_UNITS = ‸`)).sort(), ['LINEAR_UNITS = imperial', 'LINEAR_UNITS = in', 'LINEAR_UNITS = inch', 'LINEAR_UNITS = metric', 'LINEAR_UNITS = mm']);
  assert.deepEqual(await at(`${head}[JOINT_1]\nTYPE = L‸`), ['TYPE = LINEAR']);
  assert.deepEqual(await at(`${head}# LIN‸`), []);
  const machine = `${head}[RS274NGC]\nSUBROUTINE_PATH = subs\n`;
  assert.deepEqual(await at(`${machine}REMAP = M400 modalgroup=10 ngc=c‸`), ['REMAP = M400 modalgroup=10 ngc=clamp']);
  assert.deepEqual(await at(`${machine}[HALUI]\nMDI_COMMAND = o<m‸`), ['MDI_COMMAND = o<measure']);
});

session('definition: from the INI to subs and files', { files }, async (client) => {
  client.open(name);
  const leads = async (piece, into) => locations(await client.request('textDocument/definition', client.params(name, piece, into))).map((one) => `${client.name(one.uri)}:${one.range.start.line}`);
  assert.deepEqual(await leads('ngc=clamp', 5), ['subs/clamp.ngc:0']);
  assert.deepEqual(await leads('measure diameter', 3), ['subs/measure.ngc:1']);
  assert.deepEqual(await leads('o<measure>', 4), ['subs/measure.ngc:1']);
  assert.deepEqual(await leads('slot.ngc', 2), ['subs/slot.ngc:1']);
  assert.deepEqual(await leads('tool.tbl', 2), ['tool.tbl:0']);
  assert.deepEqual(await leads('linuxcnc.var', 2), ['linuxcnc.var:0']);
  assert.deepEqual(await leads('diameter depth', 2), []);
  const links = await client.request('textDocument/documentLink', client.document(name));
  assert.deepEqual(links.map((one) => client.name(one.target)).sort(), ['linuxcnc.var', 'subs/clamp.ngc', 'subs/measure.ngc', 'subs/measure.ngc', 'subs/slot.ngc', 'tool.tbl']);
});

session('references: programs and INIs, from either', { files }, async (client) => {
  client.open(name);
  client.open('subs/measure.ngc');
  const places = (all) => all.map((one) => `${client.name(one.uri)}:${one.range.start.line}`).sort();
  const expected = ['machine.ini:12', 'machine.ini:15', 'nc/part.ngc:1', 'subs/measure.ngc:1', 'subs/measure.ngc:3'];
  const context = { context: { includeDeclaration: true } };
  assert.deepEqual(places(await client.request('textDocument/references', client.params('subs/measure.ngc', 'o<measure> sub', 3, context))), expected);
  assert.deepEqual(places(await client.request('textDocument/references', client.params(name, 'measure diameter', 2, context))), expected);
  const [use] = (await client.request('textDocument/references', client.params(name, 'measure diameter', 2, context))).filter((one) => client.name(one.uri) === name);
  assert.deepEqual(use.range, { start: client.at(name, 'measure diameter'), end: client.at(name, 'measure diameter', 'measure'.length) });
});

session('the outline, and questions that an INI has no answer to', { files }, async (client) => {
  client.open(name);
  const symbols = await client.request('textDocument/documentSymbol', client.document(name));
  assert.deepEqual(symbols.map((one) => one.name), ['EMC', 'DISPLAY', 'RS274NGC', 'MACROS', 'HALUI', 'EMCIO', 'TRAJ', 'KINS']);
  assert.deepEqual(symbols[7].children.map((one) => [one.name, one.detail]), [['KINEMATICS', 'trivkins'], ['JOINTS', '3']]);
  for (const method of ['textDocument/formatting', 'textDocument/foldingRange', 'textDocument/semanticTokens/full'])
    assert.equal(await client.request(method, client.document(name, { options: { tabSize: 2, insertSpaces: true } })), null, method);
});
