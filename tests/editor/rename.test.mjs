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

// A rename puts no name where another one is, and changes all places together: one rule for labels, subs and parameters.

/** Asks for a rename of the first `#` or `o` of a piece; gives the message of the refusal, or the texts afterwards. */
async function attempt(client, name, piece, newName) {
  const params = client.params(name, piece, 1, { newName });
  return client.request('textDocument/rename', params).then(
    (edit) => client.afterEdit(edit),
    (error) => {
      assert.ok([-32602, -32803].includes(error.code), `${newName}: ${error.code}`);
      return error.message;
    },
  );
}

const parameters = {
  'main.ngc': `#<depth> = 2
#<feed> = 300
#<_wide> = 4
#3 = 1
#100 = 7
o<hole> sub
  #<depth> = #1
  #<q> = #3
  #4 = [#1 * 2]
  G1 Z-#<depth> F[#<q> + #4]
o<hole> endsub
G1 Z-#<depth> F#<feed> X#3 Y#100
(debug, depth #<DEPTH>, number #3)
(a note on #<depth>)
o<hole> call [#<depth>]
o<other> call
G0 X##<depth> Y[EXISTS[#<feed>]]
M2
`,
  'other.ngc': `o<other> sub
  G0 X#<_wide> Y#100 Z#<_tall>
  #<_tall> = 1
o<other> endsub
`,
};

session('a parameter is renamed on all lines of its scope, in what is printed and in numbers that are computed from it', { files: parameters }, async (client) => {
  client.open('main.ngc');
  // In the sub `#<depth>` is another one; a comment that prints nothing is text.
  const after = parameters['main.ngc']
    .split('\n')
    .map((one, i) => (i >= 5 && i <= 10 ? one : one.startsWith('(a note') ? one : one.replace(/#<depth>/gi, '#<deep>')))
    .join('\n');
  assert.equal((await attempt(client, 'main.ngc', ['#<depth>', 0], '#<deep>'))['main.ngc'], after);
  assert.equal((await attempt(client, 'main.ngc', '#<DEPTH>', 'deep'))['main.ngc'], after, 'from the comment, too');
});

session('a shared parameter is renamed in all programs', { files: parameters }, async (client) => {
  client.open('main.ngc');
  const all = (from, to) => Object.fromEntries(Object.entries(parameters).map(([name, text]) => [name, text.replaceAll(from, to)]));
  assert.deepEqual(await attempt(client, 'main.ngc', '#<_wide>', '#<_width>'), all('#<_wide>', '#<_width>'));
});

session('programs that checks leave out are renamed with the others', { files: { ...parameters, '.owlintignore': 'other.ngc\n' } }, async (client) => {
  client.open('main.ngc');
  assert.match((await attempt(client, 'main.ngc', '#<_wide>', '#<_width>'))['other.ngc'], /#<_width>/);
});

session('a parameter does not get the name of another one', { files: parameters }, async (client) => {
  client.open('main.ngc');
  const refused = async (piece, newName, why) => assert.match(await attempt(client, 'main.ngc', piece, newName), why);
  await refused(['#<depth>', 0], '#<feed>', /`#<feed>` is used on line 2 already/);
  await refused(['#<depth>', 0], '#<Fe ed>', /cannot have ` `/);
  await refused(['#<depth>', 1], '#<q>', /`#<q>` is used on line 8 already/); // in the sub
  await refused('#<_wide>', '#<_tall>', /`#<_tall>` is used on line 2 of other\.ngc already/);
  await refused('#<_wide>', '#<wide>', /`_`/);
  await refused(['#<depth>', 0], '#<_depth>', /`_`/);
  for (const own of ['#<_feed>', '#<_x>', '#<_ini[a]b>', '#<_value>']) assert.match(await attempt(client, 'main.ngc', '#<_wide>', own), /LinuxCNC's own|cannot have/, own);
  await refused(['#<depth>', 0], '#<n_args>', /LinuxCNC's own/);
  await refused(['#<depth>', 0], '#9', /keeps a name/);
});

session('a number is renamed only where nothing computes one', { files: parameters }, async (client) => {
  client.open('main.ngc');
  assert.match(await attempt(client, 'main.ngc', ['#3', 0], '#9'), /computed/); // ##<depth>
  client.replace('main.ngc', ['X##<depth> ', '']);
  assert.match(await attempt(client, 'main.ngc', ['#3', 0], '#4000'), /shared by all/);
  const after = client.text('main.ngc').split('\n').map((one, i) => (i >= 5 && i <= 10 ? one : one.replace(/#3\b/g, '#9'))).join('\n');
  assert.equal((await attempt(client, 'main.ngc', ['#3', 0], '#9'))['main.ngc'], after);
  assert.match(await attempt(client, 'main.ngc', '#1\n', '#9'), /argument of `o<hole>`/);
  assert.match(await attempt(client, 'main.ngc', '#4 =', '#1'), /`#1` is used on line 7 already/);
  assert.match((await attempt(client, 'main.ngc', '#4 =', '#12'))['main.ngc'], /#12 = \[#1 \* 2\]/);
  const shared = await attempt(client, 'main.ngc', '#100 =', '#101');
  assert.match(shared['main.ngc'], /Y#101/);
  assert.match(shared['other.ngc'], /Y#101/);
  assert.match(await attempt(client, 'main.ngc', '#100 =', '#5420'), /LinuxCNC's own/);
  client.replace('main.ngc', ['M2\n', '(print,#101)\nM2\n']);
  assert.match(await attempt(client, 'main.ngc', '#100 =', '#101'), /`#101` is used on line 18 already/);
});

session('prepareRename says why a name cannot be changed', { files: parameters }, async (client) => {
  client.open('main.ngc', 'X#<_feed> Y#<missing> Z#5420\no<lost> call\no<s> sub\nG0 X#2\no<s> endsub\no100 endif\nM2\n');
  const why = async (piece) => (await client.refusal('textDocument/prepareRename', client.params('main.ngc', piece, 1))).message;
  assert.match(await why('#<_feed>'), /LinuxCNC's own/);
  assert.match(await why('#<missing>'), /assigned nowhere/);
  assert.match(await why('#5420'), /LinuxCNC's own/);
  assert.match(await why('#2'), /argument of `o<s>`/);
  assert.match(await why('o<lost>'), /not known/);
});

const machine = {
  ...files,
  'probe.ngc': 'o<probe> sub\n  G0 X#1\no<probe> endsub\n',
  'helper.ngc': 'o<helper> sub\n  o500 call\no<helper> endsub\no500 sub\n  G0 X1\no500 endsub\n',
  'second.ngc': 'o<second> sub\n  o600 call\no<second> endsub\no600 sub\n  G0 X2\no600 endsub\n',
  'button.ngc': 'o<button> sub\n  o<helper> call\n  o<second> call\no<button> endsub\n',
  'machine.ini': `[RS274NGC]
REMAP = M400 modalgroup=10 ngc=probe
ON_ABORT_COMMAND = O <both> call
[DISPLAY]
NGCGUI_SUBFILE = face.ngc
[HALUI]
MDI_COMMAND = G0 Z1 ; o<second> call [#<_clear>]
[MACROS]
MACRO = button xinc yinc
`,
};

session('what the INI names keeps its name', { files: machine }, async (client) => {
  client.open(main);
  const names = { probe: 'REMAP` on line 2', both: 'ON_ABORT_COMMAND` on line 3', face: 'NGCGUI_SUBFILE` on line 5', second: 'MDI_COMMAND` on line 7', button: 'MACRO` on line 9' };
  for (const [sub, place] of Object.entries(names)) {
    client.open(`${sub}.ngc`);
    const why = await attempt(client, `${sub}.ngc`, [`o<${sub}> sub`, 0], 'fresh');
    assert.equal(why, `\`${place} of machine.ini names \`o<${sub}>\``);
    const prepared = await client.refusal('textDocument/prepareRename', client.params(`${sub}.ngc`, [`o<${sub}> sub`, 0], 1));
    assert.equal(prepared.message, why);
  }
  client.open('helper.ngc');
  const after = await attempt(client, 'helper.ngc', 'o<helper> sub', 'fresh');
  assert.match(after['button.ngc'], /o<fresh> call/);
  assert.ok('fresh.ngc' in after && !('helper.ngc' in after));
  client.open('extra.ngc', '#<_clear> = 1\n#<_way> = 2\nG0 X#<_clear> Y#<_way>\nM2\n');
  assert.match(await attempt(client, 'extra.ngc', '#<_clear> =', '#<_c>'), /MDI_COMMAND` on line 7 of machine\.ini/);
  assert.match(await attempt(client, 'extra.ngc', '#<_way> =', '#<_clear>'), /MDI_COMMAND` on line 7 of machine\.ini/);
});

session('a helper does not get the label of one in another file of the same run', { files: machine }, async (client) => {
  client.open('helper.ngc');
  assert.match(await attempt(client, 'helper.ngc', 'o500 sub', 'o600'), /`o600` is used on line 2 of second\.ngc already/);
  assert.equal((await attempt(client, 'helper.ngc', 'o500 sub', 'o700'))['helper.ngc'], machine['helper.ngc'].replaceAll('500', '700'));
});

session('whose sub a call means must be certain', { files: { ...machine, 'clash.ngc': 'o<clash> sub\n  o<helper> call\n  o500 call\no<clash> endsub\no500 sub\n  G0 X3\no500 endsub\n' } }, async (client) => {
  client.open(main, 'o<helper> call\no<clash> call\no500 call\nM2\n');
  client.open('helper.ngc');
  assert.match(await attempt(client, 'helper.ngc', 'o500 sub', 'o700'), /`o500` on line 3 of main\.ngc may be the one of helper\.ngc or of clash\.ngc/);
  client.replace(main, ['o500 call\n', '']);
  const after = await attempt(client, 'helper.ngc', 'o500 sub', 'o700'); // told apart
  assert.equal(after['helper.ngc'], machine['helper.ngc'].replaceAll('500', '700'));
  assert.match(after['clash.ngc'], /o500 call/);
});

session('a sub does not get the name of a file, of another sub, or of one that is computed', { files: machine }, async (client) => {
  client.open(main);
  assert.match(await attempt(client, main, 'o<drill> sub', 'probe'), /the file .*probe\.ngc exists already/);
  client.replace(main, ['M2\n', 'o#5 call\nM2\n']);
  assert.match(await attempt(client, main, 'o<drill> sub', 'o300'), /line 21 is computed/);
  assert.match((await attempt(client, main, 'o<drill> sub', 'bore'))[main], /o<bore> sub/);
  client.open('lathe.ngc', 'o100 sub\nG1 X1\no100 endsub\nG71 Q100 D1 R1\nM2\n');
  assert.match(await attempt(client, 'lathe.ngc', 'o100 sub', 'o200'), /the Q on line 4 runs `o100`/);
  client.open('path.ngc', 'o<./helper> call\nM2\n');
  client.open('helper.ngc');
  assert.match(await attempt(client, 'helper.ngc', 'o<helper> sub', 'fresh'), /`o<\.\/helper>` on line 1 of path\.ngc calls it by a path/);
});

session('a file does not get the name of a sub that a program calls before it defines it', { files: machine }, async (client) => {
  client.open(main, 'o<fresh> call\nM2\no<fresh> sub\nG0 X3\no<fresh> endsub\n');
  client.open('helper.ngc');
  assert.match(await attempt(client, 'helper.ngc', 'o<helper> sub', 'fresh'), /`o<fresh>` is used on line 1 of main\.ngc already/);
});

session('a line does not get longer than LinuxCNC reads', { files }, async (client) => {
  client.open(main, `#<a> = 1\n(${'x'.repeat(230)}) G0 X#<a>\nM2\n`);
  assert.match(await attempt(client, main, ['#<a>', 0], `#<${'b'.repeat(30)}>`), /line 2 would be longer than the 252 characters/);
});
