// node build.mjs [--modules DIR] [--out DIR]: one page and one program, with all that they need inside.
//
//   DIR/report.html  the page; @STUDY@ in it stands for the study
//   DIR/svg.mjs      the charts as SVG files
//
// --modules: where `npm ci` has put node_modules, if not here. The same sources give the same bytes.

import {createHash} from 'node:crypto';
import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';
import {parseArgs} from 'node:util';

const here = dirname(fileURLToPath(import.meta.url));
const {values: options} = parseArgs({options: {modules: {type: 'string', default: here}, out: {type: 'string', default: join(here, 'dist')}}});
const modules = join(resolve(options.modules), 'node_modules');
const {build} = createRequire(join(modules, 'x.js'))('esbuild');

/** What stands in the page of each library: its licence, and what that asks to pass on. */
const licences = [
  ['Apache ECharts', ['echarts/LICENSE', 'echarts/NOTICE', 'echarts/licenses/LICENSE-d3']], ['zrender', ['zrender/LICENSE']], ['three.js', ['three/LICENSE']],
  ['tslib', ['tslib/LICENSE.txt']],
];

const versionOf = (folder) => JSON.parse(readFileSync(join(modules, folder, 'package.json'), 'utf8')).version;

function licenceTexts() {
  return licences.map(([name, files]) => {
    const texts = files.map((file) => readFileSync(join(modules, file), 'utf8').trim());
    return `${name} ${versionOf(files[0].split('/')[0])}\n\n${texts.join('\n\n')}`;
  }).join(`\n\n${'-'.repeat(80)}\n\n`);
}

async function bundled(entry, more) {
  const result = await build({
    entryPoints: [join(here, entry)], bundle: true, minify: true, charset: 'ascii', legalComments: 'eof', write: false, nodePaths: [modules], logLevel: 'warning',
    absWorkingDir: here, ...more,
  });
  return result.outputFiles[0].text.trim();
}

/** A library that comes in unnoticed would have no licence in the page. */
async function checkLibraries() {
  const {metafile} = await build({entryPoints: [join(here, 'src/main.js')], bundle: true, write: false, nodePaths: [modules], metafile: true, logLevel: 'silent', absWorkingDir: here});
  const used = new Set(Object.keys(metafile.inputs).flatMap((path) => /node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(path)?.slice(1, 2) ?? []));
  const known = new Set(licences.map(([, [file]]) => file.split('/')[0]));
  for (const name of used) if (!known.has(name)) throw new Error(`the page contains ${name}, whose licence build.mjs does not name`);
}

/** Each mark once, and by a function, since $& in a text means something to `replace`. */
function filled(template, parts) {
  return Object.entries(parts).reduce((text, [mark, part]) => {
    if (text.split(mark).length !== 2) throw new Error(`${mark} has to be in the template once`);
    return text.replace(mark, () => part);
  }, template);
}

const inScript = (text) => text.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
const escaped = (text) => text.replaceAll('</script', '< /script');
const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

async function page() {
  const script = inScript(await bundled('src/main.js', {format: 'iife', target: 'es2021', platform: 'browser'}));
  const style = await bundled('src/styles/page.css', {target: ['chrome109', 'firefox115', 'safari16']});
  // Nothing but this script runs, whatever a study contains, and nothing is fetched.
  const policy = `default-src 'none'; script-src ${hash(script)}; style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; form-action 'none'`;
  const html = filled(readFileSync(join(here, 'src/page.html'), 'utf8'), {'@POLICY@': policy, '@STYLE@': style, '@LICENCES@': `\n${escaped(licenceTexts())}\n`, '@SCRIPT@': script});
  if (html.split('@STUDY@').length !== 2) throw new Error('@STUDY@ has to be in the page once');
  return html;
}

await checkLibraries();
mkdirSync(options.out, {recursive: true});
writeFileSync(join(options.out, 'report.html'), await page());
writeFileSync(join(options.out, 'svg.mjs'), `${await bundled('svg.mjs', {format: 'esm', target: 'node18', platform: 'node'})}\n`);
