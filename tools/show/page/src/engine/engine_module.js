// SPDX-License-Identifier: MIT
// The WebAssembly module, for the page and for its workers.
export async function loadModule() {
  const address = new URL('./crevice_page.js', import.meta.url).href;
  const {default: createModule} = await import(address);
  return createModule();
}
