// Bundle the page into dist/, which ships inside the Python package. Run: npm install && npm run build
import { build } from 'esbuild';
import { readFile, rm, copyFile, readdir, stat } from 'node:fs/promises';
import { join } from 'node:path';

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

const limit = 2.5e6;
const out = process.argv[2] ?? 'dist';
await rm(out, { recursive: true, force: true });
await build({
  entryPoints: { door: 'src/door.mjs', app: 'src/main.mjs', page: 'src/style/page.css' },
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
  plugins: [onlyWoff2],
  logLevel: 'warning',
});
await copyFile('src/index.html', join(out, 'index.html'));
await copyFile('src/icon.svg', join(out, 'icon.svg'));

const sizes = await Promise.all(
  (await readdir(out, { recursive: true, withFileTypes: true }))
    .filter((f) => f.isFile())
    .map(async (f) => (await stat(join(f.parentPath, f.name))).size),
);
const total = sizes.reduce((a, b) => a + b, 0);
console.log(`${out}: ${sizes.length} files, ${(total / 1e6).toFixed(2)} MB`);
if (total > limit) throw new Error(`${out} weighs ${total} bytes, more than ${limit}`);
