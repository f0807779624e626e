import vegaEmbed from "vega-embed";
// Draws each figure of the page from the specification that stands in it. Figures are drawn in light colours, which the
// page's style sheet changes on dark screens: so they are saved and printed for paper.
(function () {
  "use strict";
  const ink = "#1c1c1a", soft = "#4c4c48", thin = "#e3e3e0", paper = "#ffffff";
  const font = getComputedStyle(document.body).fontFamily;
  const config = {
    background: paper, font, padding: {left: 2, top: 2, right: 14, bottom: 2}, view: {stroke: null},
    mark: {aria: false}, text: {color: ink, fontSize: 13}, rule: {color: ink},
    axis: {
      labelColor: ink, labelFontSize: 13, labelPadding: 6, titleColor: soft, titleFontSize: 13,
      titleFontWeight: "normal", titlePadding: 8, labelSeparation: 8, gridColor: thin, domain: false, ticks: false
    },
    legend: {
      orient: "top", direction: "horizontal", title: null, labelColor: ink, labelFontSize: 13, symbolType: "square",
      symbolStrokeWidth: 0, symbolSize: 160, columnPadding: 12
    }
  };
  const options = {
    mode: "vega-lite", renderer: "svg", config, defaultStyle: false, forceActionsMenu: true,
    actions: {export: true, source: false, compiled: false, editor: false}, scaleFactor: {svg: 1, png: 3},
    tooltip: {disableDefaultStyle: true}
  };

  function menu(figure, view) {
    const details = figure.querySelector("details");
    const name = figure.querySelector("figcaption b").textContent.trim();
    details.removeAttribute("title");
    details.querySelector("summary").setAttribute("aria-label", "Save " + name);
    details.querySelector("summary").title = "Save this figure";
    // The menu makes its files when a mouse button goes down; keys need them, too.
    details.addEventListener("toggle", async () => {
      if (!details.open) return;
      for (const link of details.querySelectorAll("a")) {
        link.removeAttribute("target");
        const type = link.download.split(".").pop();
        link.href = await view.toImageURL(type, options.scaleFactor[type]);
      }
      details.dataset.ready = "yes";
    });
    details.addEventListener("keydown", event => {
      if (event.key !== "Escape") return;
      details.open = false;
      details.querySelector("summary").focus();
    });
  }

  // A table that is cut says so.
  const marked = new ResizeObserver(entries => {
    for (const {target} of entries) target.classList.toggle("cut", target.scrollWidth > target.clientWidth + 1);
  });
  for (const one of document.querySelectorAll(".scroll")) marked.observe(one);

  for (const figure of document.querySelectorAll("figure")) {
    const specification = figure.querySelector("script[type='application/json']");
    if (!specification) continue;
    const drawing = figure.querySelector(".drawing");
    vegaEmbed(drawing, JSON.parse(specification.textContent), {...options, downloadFileName: figure.id})
      .then(made => menu(figure, made.view))
      .then(() => { figure.dataset.drawn = "yes"; })
      .catch(error => {
        console.error(error);
        drawing.innerHTML = "<p class='failed'>This figure could not be drawn; the tables hold its numbers.</p>";
      });
  }
})();
