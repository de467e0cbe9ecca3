// Tables as text, for files and for the clipboard. Numbers keep all digits.

/** @typedef {import('../types.js').Table} Table */

const text = (/** @type {any} */ value) => value === null || value === undefined ? '' : String(value);
const quoted = (/** @type {string} */ value) => /[",\r\n]/.test(value) ? `"${value.replaceAll('"', '""')}"` : value;

/** As RFC 4180 has it. @param {Table} table */
export function csv(table) {
  const lines = [table.columns.map(({title}) => title), ...table.rows.map((row) => table.columns.map(({key}) => text(row[key])))];
  return lines.map((line) => `${line.map(quoted).join(',')}\r\n`).join('');
}

/** With tabs, as spreadsheets take it from the clipboard. @param {Table} table */
export function tabbed(table) {
  const lines = [table.columns.map(({title}) => title), ...table.rows.map((row) => table.columns.map(({key}) => text(row[key]).replace(/[\t\r\n]/g, ' ')))];
  return lines.map((line) => `${line.join('\t')}\n`).join('');
}

/** @param {string} name @param {string} content */
export function download(name, content) {
  const url = URL.createObjectURL(new Blob([content], {type: 'text/csv;charset=utf-8'}));
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

/** @param {string} content @returns {Promise<boolean>} whether it is on the clipboard */
export async function copy(content) {
  try {
    await navigator.clipboard.writeText(content);
    return true;
  } catch {
    return copyBySelection(content);
  }
}

/** Where a page may not reach the clipboard by itself, as some do not from a file. @param {string} content */
function copyBySelection(content) {
  const area = document.createElement('textarea');
  area.value = content;
  document.body.append(area);
  area.select();
  const done = document.execCommand('copy');
  area.remove();
  return done;
}
