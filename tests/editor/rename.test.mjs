// Renaming: a label on all lines of its block, a sub in all files together with the file that is named after it.
import assert from 'node:assert/strict';
import { session } from './client.mjs';
import * as places from './places.mjs';
import { files } from './shop.mjs';

const main = 'main.ngc';

/** Renames what stands there; the new name is written as prepareRename shows the old one. */
async function rename(client, name, [piece, into], before, after) {
  const place = client.params(name, piece, into);
  const { range, placeholder } = await client.request('textDocument/prepareRename', place);
  assert.equal(places.slice(client.text(name), range, client.encoding), placeholder);
  assert.ok(placeholder.includes(before), placeholder);
  return client.request('textDocument/rename', { ...place, newName: placeholder.replace(before, after) });
}

const line = (text, number, from, to) => text.split('\n').map((one, i) => (number.includes(i) ? one.replace(from, to) : one)).join('\n');

session('a label, on all lines of its block and on no other', { files }, async (client) => {
  client.open(main);
  const edit = await rename(client, main, ['o120 else\n', 2], '120', '130');
  assert.deepEqual(client.afterEdit(edit), { ...files, [main]: files[main].replaceAll('o120', 'o130') });
  const loop = await rename(client, main, ['o100 break', 1], '100', '140');
  assert.equal(client.afterEdit(loop)[main], line(files[main], [11, 15, 19], 'o100', 'o140'));
  const inSub = await rename(client, main, ['o100 endrepeat', 1], '100', '150');
  assert.equal(client.afterEdit(inSub)[main], line(files[main], [2, 7], 'o100', 'o150'));
});

session('edits carry the version that they are about', { files }, async (client) => {
  client.open(main, files[main], 41);
  const { documentChanges } = await rename(client, main, ['o120 if', 2], '120', '130');
  assert.deepEqual(documentChanges.map((one) => one.textDocument), [{ uri: client.uri(main), version: 41 }]);
});

session('a sub of the program itself', { files }, async (client) => {
  client.open(main);
  const edit = await rename(client, main, ['o<drill> return', 4], 'drill', 'bore');
  assert.ok(edit.documentChanges.every((one) => one.kind === undefined), 'no file is called drill');
  assert.deepEqual(client.afterEdit(edit), { ...files, [main]: files[main].replaceAll('<drill>', '<bore>') });
});

for (const [from, name, place] of [
  ['a call', main, ['o<face> call', 4]],
  ['the definition', 'face.ngc', ['o<face> sub', 4]],
]) {
  session(`a sub with a file of its own, from ${from}`, { files }, async (client) => {
    client.open(name);
    const edit = await rename(client, name, place, 'face', 'plane');
    const renamed = Object.fromEntries(Object.entries(files).map(([file, text]) => [file.replace('face', 'plane'), text.replaceAll('<face>', '<plane>')]));
    assert.deepEqual(client.afterEdit(edit), renamed);
    const renamings = edit.documentChanges.filter((one) => one.kind === 'rename');
    assert.equal(renamings.length, 1);
    assert.equal(client.name(renamings[0].oldUri), 'face.ngc');
    const open = edit.documentChanges.find((one) => one.textDocument?.uri === client.uri(name));
    assert.equal(open.textDocument.version, 1);
  });
}

session('a label of M98', { files }, async (client) => {
  client.open('fanuc.ngc');
  const place = client.params('fanuc.ngc', 'O100', 1);
  const { placeholder } = await client.request('textDocument/prepareRename', place);
  const edit = await client.request('textDocument/rename', { ...place, newName: placeholder.replace('100', '200') });
  assert.equal(client.afterEdit(edit)['fanuc.ngc'].toUpperCase(), files['fanuc.ngc'].replaceAll('100', '200'));
});

session('where nothing can be renamed', { files }, async (client) => {
  client.open(main);
  for (const piece of ['G21 G90', 'faces where', 'M2']) {
    const place = client.params(main, piece, 1);
    const nothing = await client.request('textDocument/prepareRename', place).catch((error) => assert.equal(typeof error.code, 'number'));
    assert.equal(nothing ?? null, null, piece);
    assert.match((await client.refusal('textDocument/rename', { ...place, newName: 'o500' })).message, /\S/);
  }
});

session('new names that cannot be are refused', { files }, async (client) => {
  client.open(main);
  const refused = async (piece, newName) => {
    const error = await client.refusal('textDocument/rename', client.params(main, piece, 2, { newName }));
    assert.ok([-32602, -32803].includes(error.code), `${newName}: ${error.code}`);
    assert.match(error.message, /\S/);
  };
  for (const newName of ['', 'o<>', 'o1[2]', 'o100']) await refused('o120 if', newName); // o100 is taken there
  for (const newName of ['', 'o<>', 'o<a>b>', 'o<a(b>', 'a\nb', 'o<face>', 'face']) await refused('o<drill> sub', newName); // so is face
  // The label of the block around, in the sub: taken as well. In the main program it is free.
  await refused('o110 if', 'o100');
  const edit = await client.request('textDocument/rename', client.params(main, 'o110 if', 2, { newName: 'o120' }));
  assert.equal(client.afterEdit(edit)[main], files[main].replaceAll('o110', 'o120'));
});
