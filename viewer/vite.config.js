// SPDX-License-Identifier: GPL-3.0-or-later
// Builds dist/page.inc: the whole page, script and style in it, as a C++ raw string literal for io/write_viewer.cpp.
import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import { defineConfig } from 'vite';

const kDelimiter = 'stratareeb';

function onePage() {
  let folder;
  return {
    name: 'one-page',
    apply: 'build',
    configResolved(config) {
      folder = config.build.outDir;
    },
    writeBundle(_, bundle) {
      const text = (ending) => {
        const found = Object.values(bundle).filter(({ fileName }) => fileName.endsWith(ending));
        if (found.length !== 1) throw new Error(`${found.length} files *${ending} instead of one`);
        return found[0].code ?? String(found[0].source);
      };
      const script = text('.js').replaceAll('</script', '<\\/script');
      const page = readFileSync(`${folder}/index.html`, 'utf8')
        .replace(/\s*<script type="module"[^>]*><\/script>/, () => '')
        .replace(/\s*<link rel="stylesheet"[^>]*>/, () => `\n    <style>${text('.css')}</style>`)
        .replace('</body>', () => `<script type="module">${script}</script>\n  </body>`);
      if (page.includes(`)${kDelimiter}"`)) throw new Error('the page holds the end of its own literal');
      for (const mark of ['@@title@@', '@@model@@'])
        if (page.split(mark).length !== 2) throw new Error(`the page must have ${mark} once`);
      writeFileSync(`${folder}/page.inc`, `R"${kDelimiter}(${page})${kDelimiter}"\n`);
      for (const { fileName } of Object.values(bundle)) rmSync(`${folder}/${fileName}`);
    },
  };
}

export default defineConfig({
  base: './',
  plugins: [onePage()],
  build: {
    target: 'es2022',
    assetsDir: '',
    modulePreload: false,
    cssCodeSplit: false,
    chunkSizeWarningLimit: 2000,
    reportCompressedSize: false,
    rollupOptions: { output: { inlineDynamicImports: true, entryFileNames: 'page.js', assetFileNames: 'page.[ext]' } },
  },
});
