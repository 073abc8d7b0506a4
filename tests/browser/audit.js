// What an accessibility audit asks of a page: controls without a name, text without enough contrast, panels cut off.
({
  nameless: [...document.querySelectorAll('button, input, select, textarea, [role=slider], [role=tab]')]
    .filter((el) => el.offsetParent !== null)
    .filter((el) => !(el.getAttribute('aria-label') || el.labels?.length || el.textContent.trim() || el.title))
    .map((el) => el.outerHTML.slice(0, 120)),

  // WCAG contrast of every visible text against what is painted behind it; disabled controls are exempt there too
  faint: (() => {
    const parse = (c) => {
      const m = c.match(/[\d.]+/g).map(Number);
      return c.startsWith('color(') ? [255 * m[0], 255 * m[1], 255 * m[2], m[3] ?? 1] : [m[0], m[1], m[2], m[3] ?? 1];
    };
    const linear = (v) => (v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
    const lum = (c) => 0.2126 * linear(c[0] / 255) + 0.7152 * linear(c[1] / 255) + 0.0722 * linear(c[2] / 255);
    const over = (top, under) => [0, 1, 2].map((i) => top[i] * top[3] + under[i] * (1 - top[3]));
    const behind = (el) => {
      const layers = [];
      for (let e = el; e; e = e.parentElement) {
        const c = parse(getComputedStyle(e).backgroundColor);
        if (c[3] > 0) layers.push(c);
        if (c[3] === 1) break;
      }
      return layers.reverse().reduce((under, c) => over(c, under), [255, 255, 255]);
    };
    const bad = [];
    for (const el of document.querySelectorAll('body *')) {
      if (el.offsetParent === null || el.closest(':disabled, .offscreen, .skip, #remark, .katex-mathml, #view')) continue;
      const own = [...el.childNodes].some((n) => n.nodeType === 3 && n.textContent.trim());
      if (!own && !(el.matches('input[type=text]') && el.value)) continue;
      const under = behind(el), ink = over(parse(getComputedStyle(el).color), under);
      const [a, b] = [lum(ink), lum(under)].sort((x, y) => y - x), ratio = (a + 0.05) / (b + 0.05);
      if (ratio < 4.5) bad.push(`${ratio.toFixed(2)} ${el.tagName}.${el.className}: ${(el.value ?? el.textContent).slice(0, 30)}`);
    }
    return bad;
  })(),

  cut: [
    ...(document.documentElement.scrollWidth > innerWidth ? ['the page scrolls sideways'] : []),
    ...[...document.querySelectorAll('#rail [role=tab]:not([hidden])')]
      .filter((t) => t.offsetHeight > document.getElementById('rail').clientHeight)
      .map((t) => `the tab ${t.textContent}`),
    ...[...document.querySelectorAll('.panel:not([hidden])')].filter((p) => p.scrollWidth > p.parentElement.clientWidth + 1).map((p) => p.id),
  ],
})
