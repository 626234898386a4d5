// SPDX-License-Identifier: Apache-2.0

type Properties<T> = { [key in keyof T]?: T[key] } & { attributes?: Record<string, string> };

/** An element with properties, attributes and children, in one expression. */
export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  properties: Properties<Omit<HTMLElementTagNameMap[K], "attributes">> = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  const { attributes, ...plain } = properties;
  Object.assign(made, plain);
  for (const [name, value] of Object.entries(attributes ?? {})) made.setAttribute(name, value as string);
  made.append(...children);
  return made;
}

export function selection(id: string, options: [value: string, label: string][], chosen: string): HTMLSelectElement {
  const select = element("select", { id });
  for (const [value, label] of options) select.append(element("option", { value }, label));
  select.value = chosen;
  return select;
}

/** Puts what the section holds, except its heading, aside as what is shown without this program. */
export function setFallbackAside(section: HTMLElement): HTMLElement {
  const fallback = element("div", { className: "kerf-fallback" });
  for (const child of [...section.childNodes])
    if (!(child instanceof HTMLHeadingElement && child.tagName === "H2")) fallback.append(child);
  section.append(fallback);
  const empty = fallback.childElementCount === 0;
  if (empty) section.classList.add("kerf-alone");
  return fallback;
}

/** One line in the page; the same place holds one at a time. */
export function note(place: HTMLElement, words: string, kind: "error" | "note" = "error") {
  let line = place.querySelector<HTMLElement>(":scope > .kerf-message");
  if (words === "") return line?.remove();
  if (!line) {
    line = element("p");
    const heading = place.querySelector(":scope > h2");
    if (heading) heading.after(line);
    else place.prepend(line);
  }
  line.className = `kerf-message kerf-${kind}`;
  line.setAttribute("role", kind === "error" ? "alert" : "status");
  if (line.textContent !== words) line.textContent = words;
}
