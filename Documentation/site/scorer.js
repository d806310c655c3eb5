// Orders search results. pages.py adds the titles, keywords and words of each document. Sphinx's own
// score counts a word of a page once, and a title of a section as much as the title of a page.
const kinds = {
  "Documentation/guide/README": -6, "Documentation/guide/properties": -6,
  "Documentation/guide/choosing": 4, "Documentation/guide/paraview": 4, "Documentation/guide/": 10,
  "Documentation/methods/README": -6, "Documentation/methods/": 4,
  "Documentation/measurements": 2, "Documentation/": -4,
  "api/cpp/": 2, "api/python/": -6, "gallery/index": -6, "gallery/": -2, "CHANGELOG": -10, "": -6,
};
const typed = (new URLSearchParams(location.search).get("q") || "").trim();
const query = typed.toLowerCase();
const words = (query.match(/[a-z_][a-z0-9_]+/g) || []).map(word => word.replace(/s$/, ""));
const terms = [...words, ...words.slice(1).map((word, i) => words[i] + " " + word)];

var Scorer = {
  score: ([page, title, anchor, description, score]) => {
    const name = title.toLowerCase();
    const exact = (name == query && !anchor) || (/[a-z][A-Z]/.test(typed) && name.endsWith("::" + query));
    const kind = Object.keys(kinds).find(start => page.startsWith(start));
    const { titles, length, counts } = documents[page] || { titles: [], length: 1, counts: {} };
    const titled = words.length && titles.some(text => ` ${text} `.includes(` ${words.join(" ")} `));
    const weights = terms.map(term => counts[term] || 0).map(count => count / (count + 4 * length));
    const mean = weights.reduce((sum, weight) => sum + weight, 0) / Math.max(weights.length, 1);
    return Math.min(score, 10) + kinds[kind] + (exact ? 50 : 0) + (titled ? 18 : 0) + 40 * mean;
  },
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};
