// Findings in the editor: pushed and pulled, of open documents and of files, as text, settings and called files change.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { codes, corpus, corpusNames, session } from './client.mjs';
import { program } from './raw.mjs';

const twice = `G21 G90
o100 if [#5070 EQ 0]
  G0 X1
o100 endif
o100 if [#5070 EQ 1]
  G0 X3
o100 endif
M2
`;
const sound = twice.replaceAll(/^o100 (if \[#5070 EQ 1\]|endif\nM2)/gm, 'o110 $1');
const main = 'G21 G90\no<face> call [1]\nM2\n';
const face = 'o<face> sub\n  G0 X#1\no<face> endsub\n';
const plane = face.replaceAll('face', 'plane');
const has = (code) => (diagnostics) => codes(diagnostics).includes(code);
const none = (diagnostics) => diagnostics.length === 0;

const push = { pull: false };
const pullFiles = { files: { 'main.ngc': main, 'face.ngc': face } };
const pushFiles = { ...pullFiles, ...push };

session('a finding with all that belongs to it is pushed', { ...push, files: { 'twice.ngc': twice } }, async (client) => {
  client.open('twice.ngc', twice, 7);
  const { diagnostics, uri } = await client.waitDiagnostics('twice.ngc', 7);
  assert.equal(uri, client.uri('twice.ngc'));
  assert.equal(diagnostics.length, 1);
  const [one] = diagnostics;
  assert.deepEqual(one.range, { start: { line: 4, character: 0 }, end: { line: 4, character: 4 } });
  assert.equal(one.severity, 1);
  assert.equal(one.code, 'OW104');
  assert.match(new URL(one.codeDescription.href).protocol, /^(https|file):$/);
  assert.equal(one.source, 'owlint');
  assert.match(one.message, /^label `o100` is already used for an `if` on line 2/);
  assert.ok(!(one.tags ?? []).includes(1), 'the line is reached');
  assert.equal(one.relatedInformation.length, 1);
  const [related] = one.relatedInformation;
  assert.deepEqual(related.location, { uri, range: client.range('twice.ngc', ['o100 if', 0]) });
  assert.match(related.message, /first used here/);
  assert.ok(one.data !== undefined && one.data !== null, 'data, for code actions');
});

session('lines that no run gets to are marked as unnecessary', push, async (client) => {
  client.open('after.ngc', 'G21 G90\nG0 X1\nM2\nG0 X2\nG0 X3\n');
  const { diagnostics } = await client.waitDiagnostics('after.ngc', 1);
  assert.deepEqual(codes(diagnostics), ['OW316']);
  assert.equal(diagnostics[0].severity, 2);
  assert.deepEqual(diagnostics[0].tags, [1]);
  assert.deepEqual(diagnostics[0].range.start, { line: 3, character: 0 });
  assert.ok(diagnostics[0].range.end.line > 3 || diagnostics[0].range.end.character === 5);
  assert.match(diagnostics[0].message, /no run gets to this line/);
});

session('a rule of level info, and one that the settings select', { ...push, options: { 'extend-select': ['OW311'] } }, async (client) => {
  client.open('capital.ngc', sound.replaceAll('o110', 'O110'));
  const { diagnostics } = await client.waitDiagnostics('capital.ngc', 1, has('OW311'));
  assert.deepEqual(new Set(diagnostics.map((one) => one.severity)), new Set([3]));
});

session('every version is answered, a sound program with nothing', push, async (client) => {
  client.open('a.ngc', sound);
  assert.deepEqual((await client.waitDiagnostics('a.ngc', 1)).diagnostics, []);
  assert.deepEqual(codes((await client.waitDiagnostics('a.ngc', client.replaceAll('a.ngc', twice))).diagnostics), ['OW104']);
  const fixed = client.replace('a.ngc', [['o100 if', 1], 'o300 if'], [['o100 endif', 1], 'o300 endif']);
  assert.deepEqual((await client.waitDiagnostics('a.ngc', fixed)).diagnostics, []);
});

session('closing a document clears what was pushed', push, async (client) => {
  client.open('unsaved.ngc', twice);
  await client.waitDiagnostics('unsaved.ngc', 1, has('OW104'));
  client.closeDocument('unsaved.ngc');
  await client.waitDiagnostics('unsaved.ngc', undefined, none);
});

session('pulled, then unchanged, then changed', { files: { 'twice.ngc': twice } }, async (client) => {
  client.open('twice.ngc');
  const first = await client.pull('twice.ngc');
  assert.equal(first.kind, 'full');
  assert.deepEqual(codes(first.items), ['OW104']);
  assert.equal(first.items[0].source, 'owlint');
  assert.equal(typeof first.resultId, 'string');
  assert.deepEqual(await client.pull('twice.ngc', first.resultId), { kind: 'unchanged', resultId: first.resultId });
  client.replace('twice.ngc', ['G21 G90\n', 'G21 G90\n(one line more)\n']);
  const second = await client.pull('twice.ngc', first.resultId);
  assert.equal(second.kind, 'full');
  assert.notEqual(second.resultId, first.resultId);
  assert.equal(second.items[0].range.start.line, 5);
  assert.equal((await client.pull('twice.ngc', 'never given out')).kind, 'full');
});

session('pulled diagnostics have all that pushed ones have', { files: { 'twice.ngc': twice } }, async (client) => {
  client.open('twice.ngc');
  const items = await client.pulled('twice.ngc');
  assert.deepEqual(items[0].range, client.range('twice.ngc', ['o100', 2]));
  assert.equal(items[0].codeDescription.href, new URL(items[0].codeDescription.href).href);
  assert.match(items[0].relatedInformation[0].message, /first used here/);
});

const shop = { 'twice.ngc': twice, 'sound.ngc': sound, 'main.ngc': main, 'face.ngc': plane };
session('the workspace is pulled: files, and open documents as they stand', { files: shop }, async (client) => {
  const ask = async (previousResultIds = []) => {
    const report = await client.request('workspace/diagnostic', { identifier: 'owlint', previousResultIds });
    return Object.fromEntries(report.items.map((item) => [client.name(item.uri), item]));
  };
  client.open('sound.ngc', twice, 3);
  const first = await ask();
  assert.deepEqual(codes(first['twice.ngc'].items), ['OW104']);
  assert.equal(first['twice.ngc'].version, null);
  assert.deepEqual(codes(first['sound.ngc'].items), ['OW104'], 'the buffer counts');
  assert.equal(first['sound.ngc'].version, 3);
  assert.deepEqual(codes(first['main.ngc'].items), ['OW401']);
  assert.deepEqual(first['face.ngc']?.items ?? [], [], 'a file that another one calls is no program without its M2');

  client.replaceAll('sound.ngc', sound);
  const known = Object.values(first).map((item) => ({ uri: item.uri, value: item.resultId }));
  const second = await ask(known);
  for (const name of ['twice.ngc', 'main.ngc']) {
    assert.equal(second[name].kind, 'unchanged');
    assert.equal(second[name].resultId, first[name].resultId);
  }
  assert.equal(second['sound.ngc'].kind, 'full');
  assert.deepEqual(second['sound.ngc'].items, []);
  assert.equal(second['sound.ngc'].version, 4);
});

const everything = Object.fromEntries(corpusNames().filter((name) => !name.includes('latin1')).map((name) => [name, corpus(name)]));
session('the workspace has the findings of `owlint check FOLDER`', { files: { ...everything, ...shop } }, async (client) => {
  const { files } = JSON.parse(spawnSync(program, ['check', '--format', 'json', '.'], { cwd: client.folder, encoding: 'utf8' }).stdout);
  const levels = { error: 1, warning: 2, info: 3 };
  const line = (name, code, severity, number) => `${name} ${code} ${severity} ${number}`;
  const expected = files.flatMap((file) => file.findings.map((one) => line(file.path.replace(/^\.\//, ''), one.code, levels[one.severity], one.start.line - 1)));
  assert.ok(expected.length > 15, 'the corpus has mistakes');
  const report = await client.request('workspace/diagnostic', { previousResultIds: [] });
  const found = report.items.flatMap((item) => item.items.map((one) => line(client.name(item.uri), one.code, one.severity, one.range.start.line)));
  assert.deepEqual(found.sort(), expected.sort());
});

session('an unsaved sub file shadows the one on disk: pushed', pushFiles, async (client) => {
  client.open('main.ngc');
  assert.deepEqual((await client.waitDiagnostics('main.ngc', 1)).diagnostics, []);
  client.open('face.ngc');
  await client.waitDiagnostics('face.ngc', 1);
  client.replaceAll('face.ngc', plane);
  const { diagnostics } = await client.waitDiagnostics('main.ngc', 1, has('OW401'));
  assert.equal(diagnostics.length, 1);
  assert.deepEqual(diagnostics[0].range, client.range('main.ngc', 'o<face> call'));
  assert.equal(diagnostics[0].severity, 1);
  const [related] = diagnostics[0].relatedInformation;
  assert.equal(client.name(related.location.uri), 'face.ngc');
  assert.equal(related.location.range.start.line, 0);
  const seen = client.published.length;
  client.replaceAll('face.ngc', face);
  await client.waitDiagnostics('main.ngc', 1, none, seen);
});

session('an unsaved sub file shadows the one on disk: pulled', pullFiles, async (client) => {
  client.open('main.ngc');
  const before = await client.pull('main.ngc');
  assert.deepEqual(before.items, []);
  client.open('face.ngc', plane);
  const after = await client.pull('main.ngc', before.resultId);
  assert.deepEqual(codes(after.items ?? []), ['OW401']);
  // Closed without being saved: the file counts again.
  client.closeDocument('face.ngc');
  assert.deepEqual(await client.pulled('main.ngc'), []);
});

session('a sub file that only the editor has is no file', { files: { 'main.ngc': main } }, async (client) => {
  client.open('main.ngc');
  assert.deepEqual(codes(await client.pulled('main.ngc')), ['OW208']);
  client.open('other.ngc', face);
  assert.deepEqual(codes(await client.pulled('main.ngc')), ['OW208']);
});

session('files that change on disk: pushed', pushFiles, async (client) => {
  client.open('main.ngc');
  await client.waitDiagnostics('main.ngc', 1, none);
  client.writeFile('face.ngc', plane);
  client.watched('face.ngc', 2);
  await client.waitDiagnostics('main.ngc', 1, has('OW401'));
  client.removeFile('face.ngc');
  client.watched('face.ngc', 3);
  await client.waitDiagnostics('main.ngc', 1, has('OW208'));
  const seen = client.published.length;
  client.writeFile('face.ngc', face);
  client.watched('face.ngc', 1);
  await client.waitDiagnostics('main.ngc', 1, none, seen);
});

session('files that change on disk: a client that pulls is asked to', pullFiles, async (client) => {
  client.open('main.ngc');
  assert.deepEqual(await client.pulled('main.ngc'), []);
  client.writeFile('face.ngc', plane);
  client.watched('face.ngc', 2);
  assert.deepEqual(codes(await client.pulled('main.ngc')), ['OW401']);
  assert.ok(client.asked.includes('workspace/diagnostic/refresh'), `asked: ${client.asked}`);
});

session('a program that is open is not read from disk', { files: { 'a.ngc': sound } }, async (client) => {
  client.open('a.ngc');
  assert.deepEqual(await client.pulled('a.ngc'), []);
  client.writeFile('a.ngc', twice);
  client.watched('a.ngc', 2);
  assert.deepEqual(await client.pulled('a.ngc'), []);
});

const configured = { 'twice.ngc': twice, 'owlint.toml': 'ignore = ["OW104"]\n' };
session('owlint.toml is heeded, and read again when it changes', { ...push, files: configured }, async (client) => {
  client.open('twice.ngc');
  assert.deepEqual((await client.waitDiagnostics('twice.ngc', 1)).diagnostics, []);
  client.writeFile('owlint.toml', '[severity]\nOW104 = "info"\n');
  client.watched('owlint.toml', 2);
  assert.equal((await client.waitDiagnostics('twice.ngc', 1, has('OW104'))).diagnostics[0].severity, 3);
  client.removeFile('owlint.toml');
  client.watched('owlint.toml', 3);
  await client.waitDiagnostics('twice.ngc', 1, (all) => all[0]?.severity === 1);
});

session('a broken owlint.toml stops nothing', { files: configured }, async (client) => {
  client.open('twice.ngc');
  assert.deepEqual(await client.pulled('twice.ngc'), []);
  client.writeFile('owlint.toml', 'ignore = [[["OW');
  client.watched('owlint.toml', 2);
  await client.pull('twice.ngc').catch((error) => assert.equal(typeof error.code, 'number'));
  assert.ok(Array.isArray(await client.request('textDocument/foldingRange', client.document('twice.ngc'))));
  client.writeFile('owlint.toml', '');
  client.watched('owlint.toml', 2);
  assert.deepEqual(codes(await client.pulled('twice.ngc')), ['OW104']);
});

session('settings that change', { files: { 'twice.ngc': twice } }, async (client) => {
  client.open('twice.ngc');
  assert.deepEqual(codes(await client.pulled('twice.ngc')), ['OW104']);
  client.notify('workspace/didChangeConfiguration', { settings: { owlint: { ignore: ['OW1'] } } });
  assert.deepEqual(await client.pulled('twice.ngc'), []);
});

session('a folder that is added is part of the workspace', { files: {} }, async (client) => {
  client.notify('workspace/didChangeWorkspaceFolders', { event: { added: [], removed: [{ uri: client.uri('.').replace(/\/\.?$/, ''), name: 'shop' }] } });
  client.writeFile('twice.ngc', twice);
  const listed = async () => (await client.request('workspace/diagnostic', { previousResultIds: [] })).items.map((item) => client.name(item.uri));
  assert.deepEqual(await listed(), []);
  client.notify('workspace/didChangeWorkspaceFolders', { event: { added: [{ uri: client.uri('.').replace(/\/\.?$/, ''), name: 'shop' }], removed: [] } });
  assert.deepEqual(await listed(), ['twice.ngc']);
});

const manyFiles = Object.fromEntries(Array.from({ length: 450 }, (_, i) => [`part${i}.ngc`, i % 100 === 0 ? twice : sound]));
session('long work is shown: reading a large folder, and checking it', { files: manyFiles }, async (client) => {
  const report = await client.request('workspace/diagnostic', { previousResultIds: [] });
  assert.equal(report.items.length, 450);
  assert.equal(report.items.filter((item) => item.items.length > 0).length, 5);
  for (const work of ['owlint: reading programs', 'owlint: checking programs']) {
    const reports = client.progress.filter(({ token }) => token === work).map(({ value }) => value);
    assert.deepEqual(reports.map(({ kind }) => kind), ['begin', 'report', 'report', 'report', 'end'], work);
    assert.deepEqual(reports.slice(1, 4).map(({ message }) => message), ['0 of 450', '200 of 450', '400 of 450']);
    assert.ok(reports.slice(1, 4).every(({ percentage }, i, all) => percentage <= 100 && (i === 0 || percentage > all[i - 1].percentage)));
  }
  assert.equal(client.asked.filter((method) => method === 'window/workDoneProgress/create').length, 2);
});
