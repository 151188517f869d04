// SPDX-License-Identifier: MIT
// Making elements, and waiting. Text goes in as text, never as markup.
export const $ = id => document.getElementById(id);

/// Appends a new element; a name that begins with "on" is a listener, null leaves an attribute out.
export function add(parent, tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on"))
      node.addEventListener(name.slice(2), value);
    else if (value !== null)
      node.setAttribute(name, value);
  }
  node.append(...children.map(String));
  parent.append(node);
  return node;
}

export function button(parent, text, onclick, attributes = {}) {
  return add(parent, "button", {type: "button", onclick, ...attributes}, text);
}

export const press = (node, on) => node.setAttribute("aria-pressed", String(on));

/// options: [{value, text, title, group}]; keeps the choice where it still exists.
export function fillSelect(select, options, value) {
  select.replaceChildren();
  let group = null, parent = select;
  for (const option of options) {
    if (option.group !== group) {
      group = option.group;
      parent = group ? add(select, "optgroup", {label: group}) : select;
    }
    add(parent, "option", {value: option.value, title: option.title ?? null}, option.text ?? option.value);
  }
  select.value = value;
}

/// Text for a moment in a button, such as "copied".
export function flash(node, text) {
  const before = node.dataset.text ?? node.textContent;
  node.dataset.text = before;
  node.textContent = text;
  clearTimeout(node.flashing);
  node.flashing = setTimeout(() => node.textContent = before, 1500);
}

export async function copyText(text, node) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const area = add(document.body, "textarea", {class: "off-screen"});
    area.value = text;
    area.select();
    document.execCommand("copy");
    area.remove();
  }
  if (node) flash(node, "Copied");
}

export function download(name, text, type = "application/json") {
  const url = URL.createObjectURL(new Blob([text], {type}));
  add(document.body, "a", {href: url, download: name}).click();
  document.body.lastElementChild.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

export function debounce(milliseconds, call) {
  let timer = 0, last = null;
  const run = () => {
    timer = 0;
    call(...last);
  };
  const later = (...given) => {
    last = given;
    clearTimeout(timer);
    timer = setTimeout(run, milliseconds);
  };
  later.flush = () => {
    if (!timer) return;
    clearTimeout(timer);
    run();
  };
  later.cancel = () => {
    clearTimeout(timer);
    timer = 0;
  };
  later.waits = () => timer !== 0;
  return later;
}
