// Builds the pages: `npm ci && npm run build`. What is built is kept in the repository, beside a digest of its sources.
import { createHash } from "node:crypto";
import { mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { dirname, join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const root = dirname(here);
const out = process.argv[2] ?? root;
const studio = join(out, "runner", "studio", "built");
const player = join(out, "runner", "exchange", "player");

const files = (folder) => readdirSync(folder).sort().flatMap((name) => {
  const path = join(folder, name);
  return statSync(path).isDirectory() ? files(path) : [path];
});

/** Names and contents of all that the pages are built from. */
const digest = () => {
  const hash = createHash("sha256");
  const sources = [...files(join(here, "src")), ...["build.mjs", "package.json", "package-lock.json", "tsconfig.json"].map((name) => join(here, name))];
  for (const path of sources) {
    hash.update(relative(here, path).split("\\").join("/") + "\0");
    hash.update(readFileSync(path));
    hash.update("\0");
  }
  return hash.digest("hex");
};

const licence = (name) => `${name} ${JSON.parse(readFileSync(join(here, "node_modules", name, "package.json"), "utf8")).version}\n\n`
  + readFileSync(join(here, "node_modules", name, "LICENSE"), "utf8").trim();
const banner = (names) => ({ js: `/*!\n${names.map(licence).join("\n\n").replaceAll("*/", "* /")}\n*/` });

const common = { bundle: true, minify: true, target: "es2022", charset: "utf8", legalComments: "none", logLevel: "warning" };
for (const folder of [studio, player]) mkdirSync(folder, { recursive: true });
await build({ ...common, entryPoints: { studio: join(here, "src", "studio", "main.ts") }, format: "esm", outdir: studio, banner: banner(["three", "uplot"]) });
await build({ ...common, entryPoints: { player: join(here, "src", "player", "main.ts") }, format: "iife", outdir: player, banner: banner(["three"]) });
writeFileSync(join(studio, "index.html"), readFileSync(join(here, "src", "studio", "index.html")));
writeFileSync(join(studio, "sources.txt"), `${digest()}\n`);
