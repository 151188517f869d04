// SPDX-License-Identifier: MIT
// From the library's places (lines, and columns in bytes, both from 1) to offsets in a string. No page here.
const bytesOf = code => code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;

/// How many UTF-16 units of the line hold this many bytes of UTF-8.
export function unitsOf(line, bytes) {
  let units = 0;
  for (const character of line) {
    if (bytes <= 0) break;
    bytes -= bytesOf(character.codePointAt(0));
    units += character.length;
  }
  return units + Math.max(0, bytes);
}

/// {from, to} in the text; at least one character long where there is one.
export function rangeOf(text, {line = 1, column = 1, length = 0}) {
  const lines = text.split("\n"), row = Math.min(Math.max(1, line), lines.length) - 1;
  const start = lines.slice(0, row).reduce((sum, each) => sum + each.length + 1, 0), own = lines[row];
  const from = Math.min(own.length, unitsOf(own, Math.max(1, column) - 1));
  const to = Math.min(own.length, from + unitsOf(own.slice(from), length || wordBytes(own.slice(from))));
  return to > from ? {from: start + from, to: start + to}
                   : {from: start + Math.max(0, Math.min(from, own.length - 1)), to: start + Math.max(own.length && 1, to)};
}

// Where no length is known: the word there, else one character.
const wordBytes = rest => /^\w+/.exec(rest)?.[0].length ?? 1;
