// Bundle the page into dist/, which ships inside the Python package. Run: npm ci && npm run build
// With --check it bundles elsewhere and fails when dist/ is not what the sources make.
import { build } from 'esbuild';
import { copyFile, mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, relative } from 'node:path';

/** KaTeX lists each font in three formats; every browser that runs this page reads woff2, so the others stay home. */
const onlyWoff2 = {
  name: 'only-woff2',
  setup(b) {
    b.onLoad({ filter: /katex\.min\.css$/ }, async ({ path }) => ({
      contents: (await readFile(path, 'utf8')).replace(
        /,url\([^)]*\.woff\) format\("woff"\),url\([^)]*\.ttf\) format\("truetype"\)/g,
        '',
      ),
      loader: 'css',
    }));
  },
};

/** The files of a folder by their place in it. */
async function filesOf(folder) {
  const found = (await readdir(folder, { recursive: true, withFileTypes: true })).filter((f) => f.isFile());
  const read = async (path) => [relative(folder, path), await readFile(path)];
  return new Map(await Promise.all(found.map((f) => read(join(f.parentPath, f.name)))));
}

/** Colours and type of the house, which reports, figures and the site read too. */
const house = JSON.parse(await readFile('../../document/identity.json', 'utf8'));
const properties = (named) =>
  Object.entries(named)
    .map(([name, value]) => `--${name.replace(/[A-Z]/g, (c) => `-${c.toLowerCase()}`)}: ${value};`)
    .join(' ');
const identityCss = {
  name: 'identity',
  setup(b) {
    b.onResolve({ filter: /identity\.css$/ }, ({ path }) => ({ path, namespace: 'identity' }));
    b.onLoad({ filter: /.*/, namespace: 'identity' }, () => ({
      contents:
        `:root { ${properties({ ...house.light.colours, ...house.type })} }\n` +
        `:root[data-theme="dark"] { ${properties(house.dark.colours)} }`,
      loader: 'css',
    }));
  },
};

const limit = 3e6;
const check = process.argv.includes('--check');
const out = check ? await mkdtemp(join(tmpdir(), 'pieper-page-')) : 'dist';
await rm(out, { recursive: true, force: true });
await build({
  entryPoints: {
    door: 'src/door.mjs',
    app: 'src/main.mjs',
    page: 'src/style/page.css',
    meshes: 'src/meshes/worker.mjs',
  },
  outdir: out,
  bundle: true,
  format: 'esm',
  splitting: true,
  minify: true,
  target: 'es2022',
  legalComments: 'none',
  chunkNames: '[name]-[hash]',
  assetNames: 'fonts/[name]',
  loader: { '.woff2': 'file' },
  plugins: [onlyWoff2, identityCss],
  logLevel: 'warning',
});
await copyFile('src/index.html', join(out, 'index.html'));
await copyFile('../../document/icon.svg', join(out, 'icon.svg'));

const made = await filesOf(out);
const total = [...made.values()].reduce((sum, content) => sum + content.length, 0);
if (total > limit) throw new Error(`the page weighs ${total} bytes, more than ${limit}`);
if (check) {
  await rm(out, { recursive: true });
  const shipped = await filesOf('dist');
  const names = [...new Set([...made.keys(), ...shipped.keys()])].sort();
  const stale = names.filter((name) => !made.get(name)?.equals(shipped.get(name) ?? Buffer.alloc(0)));
  if (stale.length) {
    console.error(`dist/ is not what the sources make; run npm run build. Different: ${stale.join(', ')}`);
    process.exit(1);
  }
}
console.log(`dist: ${made.size} files, ${(total / 1e6).toFixed(2)} MB${check ? ', up to date' : ''}`);
