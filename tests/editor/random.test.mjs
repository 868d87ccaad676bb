// Many random edits: what the server then says of the text must be what it says of the same text, freshly opened.
import assert from 'node:assert/strict';
import { corpus, session } from './client.mjs';
import { positionOf } from './places.mjs';

const edits = 10_000;
const perBatch = 200;
const perMessage = 10;
const seed = 20_261_124;

/** Numbers below `n`, the same ones in every run (mulberry32). */
function random(state) {
  return (n) => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) % n;
  };
}

const pieces = [
  ...'o0123456789[]()<>#%;/ \t\n', '\r\n', '\r', 'ä', '€', '😀', '\ufeff', '\0', 'o100 if [#1 EQ 2]\n', 'o100 else\n', 'o100 elseif [#2 GT 1]\n',
  'o100 endif\n', 'o110 while [#1 LT 5]\n', 'o110 endwhile\n', 'o110 break\n', 'o120 do\n', 'o120 while [#3]\n', 'o130 repeat [3]\n',
  'o130 endrepeat\n', 'o<drill> sub\n', 'o<drill> endsub\n', 'o<drill> return\n', 'o<drill> call [1] [2]\n', 'o<face> call\n', 'O100\n', 'M98 P100\n',
  'M99\n', 'M2\n', 'M30\n', '%\n', 'G0 X1\n', '#<depth> = [#1 + 2]\n', '(owlint: ignore OW104)\n', '; owlint: ignore-file OW2\n', 'call', 'endif', 'sub',
];

/** An index between two characters, and not between \r and \n, where the protocol has no position. */
function between(text, index) {
  if (index > 0 && /[\udc00-\udfff]/.test(text[index] ?? '') && /[\ud800-\udbff]/.test(text[index - 1])) return index - 1;
  if (index > 0 && text[index] === '\n' && text[index - 1] === '\r') return index - 1;
  return index;
}

function edit(text, next) {
  const a = between(text, next(text.length + 1));
  // Mostly small ones; now and then a stretch goes, more of it when the text has grown.
  const length = next(4) > 0 ? 0 : next(text.length > 3000 ? 400 : 12);
  const b = between(text, Math.min(text.length, a + length));
  const [from, to] = a < b ? [a, b] : [b, a];
  let inserted = next(6) === 0 ? '' : pieces[next(pieces.length)];
  if (next(8) === 0) {
    const start = between(text, next(text.length + 1));
    inserted = text.slice(start, between(text, Math.min(text.length, start + next(80)))); // copied from elsewhere
  }
  return { from, to, inserted };
}

const plain = (all) => all.map((one) => ({ code: one.code, range: one.range, severity: one.severity, message: one.message }));

for (const encoding of ['utf-16', 'utf-8']) {
  for (const name of ['keyslots-copied-label.ngc', 'rotary-flats-crlf.ngc']) {
    const share = edits / 4;
    session(`${share} random edits of ${name} in ${encoding}, seed ${seed}`, { encodings: [encoding] }, async (client) => {
      const next = random(seed + name.length + encoding.length);
      let text = corpus(name);
      client.open('edited.ngc', text);
      let findings = 0;
      for (let done = 0; done < share; ) {
        for (const stop = done + perBatch; done < stop && done < share; ) {
          const contentChanges = [];
          for (let i = 0; i < perMessage; ++i, ++done) {
            const { from, to, inserted } = edit(text, next);
            const range = { start: positionOf(text, from, encoding), end: positionOf(text, to, encoding) };
            contentChanges.push({ range, text: inserted });
            text = text.slice(0, from) + inserted + text.slice(to);
          }
          client.change('edited.ngc', contentChanges, text);
        }
        const copy = `copy-${done}.ngc`;
        client.open(copy, text);
        const [changed, fresh] = [await client.pulled('edited.ngc'), await client.pulled(copy)];
        client.closeDocument(copy);
        findings += fresh.length;
        assert.deepEqual(plain(changed), plain(fresh), `after ${done} edits:\n${JSON.stringify(text)}`);
      }
      assert.ok(findings > share / perBatch, 'broken programs have findings');
    });
  }
}
