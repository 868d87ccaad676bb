// Bundles the page into one HTML file: `node build.mjs --out FOLDER` writes FOLDER/page.html. The drawing engine is a bundle of
// its own, kept as text until a drawing is asked for.
import { build } from "esbuild";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[process.argv.indexOf("--out") + 1];
if (!process.argv.includes("--out") || !out) throw new Error("usage: node build.mjs --out FOLDER");

async function bundle(entry, options = {}) {
  const result = await build({
    entryPoints: [join(here, "src", entry)],
    bundle: true,
    minify: true,
    write: false,
    target: ["es2022"],
    legalComments: "eof",
    logLevel: "warning",
    jsx: "automatic",
    jsxImportSource: "preact",
    ...options,
  });
  return result.outputFiles[0].text;
}

// `</script` in a string would end the element that holds it.
const inElement = (code) => code.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");

const [html, css, app, engine] = await Promise.all([
  readFile(join(here, "src/page.html"), "utf8"),
  readFile(join(here, "src/page.css"), "utf8"),
  bundle("main.tsx", { format: "iife" }),
  bundle("engine.ts", { format: "iife", globalName: "owlintEngine" }),
]);
const packed = gzipSync(engine, { level: 9 }).toString("base64");
const pieces = { css, app: inElement(app), engine: packed };
await mkdir(out, { recursive: true });
await writeFile(join(out, "page.html"), html.replace(/<!--piece:(\w+)-->|\/\*piece:(\w+)\*\//g, (_, a, b) => pieces[a ?? b]));
