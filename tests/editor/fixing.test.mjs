// Changes that the server makes to a text: indentation, quick fixes, suppressions.
import assert from 'node:assert/strict';
import { codes, corpus, corpusNames, session } from './client.mjs';
import * as places from './places.mjs';

const untidy = `G21 G90
    o100 while [#5070 EQ 0]
G0 X1
      o110 if [#5420 GT 5]
  o100 break
 o110 else
\tG0   X2 (keep   inner  blanks)  \t
o110 endif
  o100 endwhile
  o120 do
G0 X3
     o120 while [#5070 EQ 1]
o130 repeat [2]
G0 X4
o130 endrepeat
  M2
`;
const tidy = `G21 G90
o100 while [#5070 EQ 0]
  G0 X1
  o110 if [#5420 GT 5]
    o100 break
  o110 else
    G0   X2 (keep   inner  blanks)  \t
  o110 endif
o100 endwhile
o120 do
  G0 X3
o120 while [#5070 EQ 1]
o130 repeat [2]
  G0 X4
o130 endrepeat
M2
`;
const twoSpaces = { tabSize: 2, insertSpaces: true };

/** Asks for edits of indentation and applies them. */
async function formatted(client, name, method = 'formatting', more = {}, options = twoSpaces) {
  const edits = await client.request(`textDocument/${method}`, client.document(name, { options, ...more }));
  for (const edit of edits ?? []) {
    const replaced = places.slice(client.text(name), edit.range, client.encoding);
    assert.match(replaced, /^[ \t]*$/, 'only blanks are replaced');
    assert.match(edit.newText, /^[ \t]*$/, 'by blanks');
    const { line } = edit.range.start;
    const lead = /^[ \t]*/.exec(client.text(name).split(/\r\n|\n|\r/)[line])[0].length;
    assert.ok(edit.range.end.line === line && edit.range.end.character <= lead, 'before the first word');
  }
  return { text: places.applyEdits(client.text(name), edits, client.encoding), edits: edits ?? [] };
}

session('formatting sets the indentation and nothing else', {}, async (client) => {
  client.open('untidy.ngc', untidy);
  assert.equal((await formatted(client, 'untidy.ngc')).text, tidy);
  const four = tidy.replace(/^ +/gm, (lead) => lead + lead);
  assert.equal((await formatted(client, 'untidy.ngc', 'formatting', {}, { tabSize: 4, insertSpaces: true })).text, four);
  const tabs = tidy.replace(/^ +/gm, (lead) => '\t'.repeat(lead.length / 2));
  assert.equal((await formatted(client, 'untidy.ngc', 'formatting', {}, { tabSize: 4, insertSpaces: false })).text, tabs);
  client.replaceAll('untidy.ngc', tidy);
  assert.deepEqual((await formatted(client, 'untidy.ngc')).edits, []);
});

session('formatting of all shop programs: only indentation, the same again, the same findings', {}, async (client) => {
  for (const name of corpusNames()) {
    client.open(name, corpus(name));
    const before = await client.pulled(name);
    const { text } = await formatted(client, name);
    client.replaceAll(name, text);
    assert.deepEqual((await formatted(client, name)).edits, [], name);
    const lines = (all) => all.map((one) => [one.code, one.severity, one.range.start.line]);
    assert.deepEqual(lines(await client.pulled(name)), lines(before), name);
    client.closeDocument(name);
  }
});

session('rangeFormatting changes the lines of the range only', {}, async (client) => {
  client.open('untidy.ngc', untidy);
  const range = { start: { line: 4, character: 1 }, end: { line: 6, character: 3 } };
  const { text } = await formatted(client, 'untidy.ngc', 'rangeFormatting', { range });
  const expected = untidy.split('\n').map((line, i) => (i >= 4 && i <= 6 ? tidy.split('\n')[i] : line)).join('\n');
  assert.equal(text, expected);
});

session('onTypeFormatting puts the line that was ended in its place', {}, async (client) => {
  for (const [draft, line, expected] of [
    ['o110 if [#5070 EQ 0]\n  G0 X1\n  o110 endif\n\nM2\n', 3, 'o110 if [#5070 EQ 0]\n  G0 X1\no110 endif\n\nM2\n'],
    ['o110 if [#5070 EQ 0]\n  G0 X1\n  o110 else\n\no110 endif\nM2\n', 3, 'o110 if [#5070 EQ 0]\n  G0 X1\no110 else\n\no110 endif\nM2\n'],
  ]) {
    client.open('draft.ngc', draft);
    const { text } = await formatted(client, 'draft.ngc', 'onTypeFormatting', { position: { line, character: 0 }, ch: '\n' });
    assert.equal(text.replace(/^[ \t]+$/gm, ''), expected);
    client.closeDocument('draft.ngc');
  }
});

const mixed = `o<bore> sub
  o300 return
o<bore> endsub
G21 G90
o<bore> call
o100 if [#5070 EQ 0]
  G0 X1
o100 endif
o100 if [#5070 EQ 1]
  G0 X2
o100 else
  G0 X3
o100 endif
M2
`;

/** The actions at a finding, as an editor asks for them. */
async function actions(client, name, code, only) {
  const diagnostics = (await client.pulled(name)).filter((one) => one.code === code);
  assert.equal(diagnostics.length, 1);
  const [{ range }] = diagnostics;
  return client.request('textDocument/codeAction', client.document(name, { range, context: { diagnostics, triggerKind: 1, ...(only ? { only } : {}) } }));
}

async function edited(client, action) {
  const full = action.edit ? action : await client.request('codeAction/resolve', action);
  return client.afterEdit(full.edit);
}

const selected = { files: { 'owlint.toml': 'extend-select = ["OW213"]\n' } };

session('a quick fix gives a copied block a label of its own', selected, async (client) => {
  client.open('mixed.ngc', mixed);
  const all = await actions(client, 'mixed.ngc', 'OW104', ['quickfix']);
  assert.ok(all.every((one) => one.kind === 'quickfix'));
  const fix = all.find((one) => /free number o101/.test(one.title));
  assert.deepEqual(codes(fix.diagnostics), ['OW104']);
  const expected = mixed.split('\n').map((line, i) => (i >= 8 ? line.replace('o100', 'o101') : line)).join('\n');
  assert.equal((await edited(client, fix))['mixed.ngc'], expected);
  client.replaceAll('mixed.ngc', expected);
  assert.deepEqual(codes(await client.pulled('mixed.ngc')), ['OW213']);
});

session('source.fixAll.owlint does what is safe, and only that', selected, async (client) => {
  client.open('mixed.ngc', mixed);
  assert.deepEqual(codes(await client.pulled('mixed.ngc')).sort(), ['OW104', 'OW213']);
  const whole = { start: { line: 0, character: 0 }, end: { line: 14, character: 0 } };
  for (const only of [['source.fixAll.owlint'], ['source.fixAll'], ['source']]) {
    const found = await client.request('textDocument/codeAction', client.document('mixed.ngc', { range: whole, context: { diagnostics: [], only } }));
    assert.deepEqual(found.map((one) => one.kind), ['source.fixAll.owlint']);
    const after = (await edited(client, found[0]))['mixed.ngc'];
    assert.equal(after.match(/^o101/gm).length, 3);
    assert.ok(after.includes('o300 return'), 'the fix of OW213 changes what the program does');
  }
  const unsafe = await actions(client, 'mixed.ngc', 'OW213', ['quickfix']);
  const fix = unsafe.find((one) => /write `o<bore> return`/.test(one.title));
  assert.notEqual(fix.isPreferred, true, 'not safe: not the one to take without a look');
  assert.ok((await edited(client, fix))['mixed.ngc'].includes('  o<bore> return\n'));
  const refactorings = await client.request('textDocument/codeAction', client.document('mixed.ngc', { range: whole, context: { diagnostics: [], only: ['refactor.extract'] } }));
  assert.deepEqual(refactorings ?? [], []);
});

session('explain a finding', {}, async (client) => {
  client.open('mixed.ngc', mixed);
  const explain = (await actions(client, 'mixed.ngc', 'OW104')).find((one) => /^explain OW104\b/i.test(one.title));
  const { command, arguments: words } = explain.command;
  assert.ok(client.capabilities.executeCommandProvider.commands.includes(command));
  const text = await client.request('workspace/executeCommand', { command, arguments: words });
  assert.match(`${text} ${client.shown}`, /if-label-reused/);
  assert.ok((await client.refusal('workspace/executeCommand', { command: 'owlint.nonsense', arguments: [] })).code < 0);
});

for (const name of ['keyslots-copied-label.ngc', 'o-ring-groove-else-mistyped-crlf.ngc']) {
  session(`suppress a finding: ${name}`, {}, async (client) => {
    client.open(name, corpus(name));
    const [{ code, range }] = await client.pulled(name);
    const suppress = (await actions(client, name, code)).find((one) => one.title === `suppress ${code} here`);
    assert.equal(suppress.kind, 'quickfix');
    const after = (await edited(client, suppress))[name];
    const added = after.split(/\r?\n/)[range.start.line];
    assert.match(added, new RegExp(`^\\s*[(;]\\s*owlint: ignore ${code}\\b`));
    const ends = (text) => new Set(text.match(/\r?\n/g));
    assert.deepEqual(ends(after), ends(corpus(name)), 'line ends stay alike');
    client.replaceAll(name, after);
    assert.deepEqual(await client.pulled(name), []);
  });
}

session('no actions where nothing was found', {}, async (client) => {
  client.open('sound.ngc', mixed.replace('o300', 'o<bore>').replace(/^o100(.*0\]|(?=.*\n.*1\]))/gm, 'o110$1'));
  assert.deepEqual(await client.pulled('sound.ngc'), []);
  const range = { start: { line: 0, character: 0 }, end: { line: 14, character: 0 } };
  const found = await client.request('textDocument/codeAction', client.document('sound.ngc', { range, context: { diagnostics: [] } }));
  assert.deepEqual(found ?? [], []);
});
