// SPDX-License-Identifier: BSD-3-Clause
// node build.mjs <folder with node_modules> <page_text.cc>
//
// Bundles src/ with three.js into one script, puts script and styles into page.html and writes the page, cut at
// its payload, as C++ source.

import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const [packages, output] = process.argv.slice(2).map((path) => resolve(path));
const here = dirname(fileURLToPath(import.meta.url));
const esbuild = createRequire(join(packages, 'package.json'))('esbuild');
const CUT = '@PAYLOAD@';

function bundle(entry) {
  const result = esbuild.buildSync({
    entryPoints: [join(here, entry)],
    nodePaths: [join(packages, 'node_modules')],
    bundle: true,
    minify: true,
    write: false,
    format: 'iife',
    target: ['chrome100', 'firefox113', 'safari16.4'],
    legalComments: 'inline',
    logLevel: 'warning',
  });
  return result.outputFiles[0].text;
}

// An HTML comment must not hold "--".
function licenses() {
  const text = readFileSync(join(packages, 'node_modules/three/LICENSE'), 'utf8').trim();
  if (text.includes('--')) throw new Error('the license of three.js cannot stand in a comment');
  return `three.js (threejs.org), in the script of this page:\n\n${text}`;
}

// Adjacent literals are one; a line of source per literal keeps them readable for compilers.
function asLiterals(text) {
  const bytes = Buffer.from(text, 'utf8');
  const lines = [];
  for (let at = 0; at < bytes.length; at += 4000) {
    const characters = Array.from(bytes.subarray(at, at + 4000), (byte) => {
      const character = String.fromCharCode(byte);
      if (character === '"' || character === '\\' || character === '?') return `\\${character}`;
      return byte >= 0x20 && byte < 0x7f ? character : `\\${byte.toString(8).padStart(3, '0')}`;
    });
    lines.push(`    "${characters.join('')}"`);
  }
  return lines.join('\n');
}

function definition(name, text) {
  const size = Buffer.byteLength(text, 'utf8');
  return `const std::string_view ${name}(\n${asLiterals(text)},\n    ${size});\n`;
}

const parts = {
  '@STYLE@': bundle('style.css').trim(),
  '@SCRIPT@': bundle('src/main.js').trim(),
  '@LICENSES@': licenses(),
};
// The tag is for the source: whose drawing a page shows is not ours to license.
const page = readFileSync(join(here, 'page.html'), 'utf8')
  .replace(/<!-- SPDX-.*-->\n/, '')
  .replace(/@[A-Z]+@/g, (mark) => parts[mark] ?? mark);
const cut = page.indexOf(CUT);
if (cut < 0) throw new Error(`page.html has no ${CUT}`);
writeFileSync(
  output,
  `// Made by page/build.mjs.\n#include "limn/viewer/page_text.h"\n\nnamespace limn {\n\n` +
    `${definition('kPageHead', page.slice(0, cut))}\n` +
    `${definition('kPageTail', page.slice(cut + CUT.length))}\n}  // namespace limn\n`,
);
