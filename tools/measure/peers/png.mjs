// SPDX-License-Identifier: MIT
// A PNG of 8 bits and four channels, as it is.
import {crc32, deflateSync} from "node:zlib";

function chunk(type, data) {
  const body = Buffer.concat([Buffer.from(type, "latin1"), data]), out = Buffer.alloc(body.length + 8);
  out.writeUInt32BE(data.length, 0);
  body.copy(out, 4);
  out.writeUInt32BE(crc32(body), body.length + 4);
  return out;
}

// `pixels`: rows from the bottom up, as textures have them.
export function png(width, height, pixels) {
  const header = Buffer.alloc(13), rows = [];
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 6, 0, 0, 0], 8);
  for (let y = height - 1; y >= 0; --y)
    rows.push(Buffer.from([0]), Buffer.from(pixels.subarray(4 * width * y, 4 * width * (y + 1))));
  return Buffer.concat([
    Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]), chunk("IHDR", header),
    chunk("IDAT", deflateSync(Buffer.concat(rows))), chunk("IEND", Buffer.alloc(0))
  ]);
}
