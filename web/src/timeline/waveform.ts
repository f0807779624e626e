// The sound's picture, by wavesurfer.js, which draws and does nothing else here.
import WaveSurfer from "wavesurfer.js";

// It writes its styles into its shadow root inline, which the page's Content-Security-Policy forbids. While it is made, what
// it writes there is taken apart: the styles are adopted as a sheet, the rest is written.
function withAdoptedStyles<T>(make: () => T): T {
  const attach = Element.prototype.attachShadow;
  Element.prototype.attachShadow = function(options) {
    const root = attach.call(this, options);
    Object.defineProperty(root, "innerHTML", {configurable: true, set(html: string) {
      delete (root as {innerHTML?: string}).innerHTML;
      root.innerHTML = html.replace(/<style[^>]*>([^]*?)<\/style>/g, (_, css: string) => {
        const sheet = new CSSStyleSheet();
        sheet.replaceSync(css);
        root.adoptedStyleSheets.push(sheet);
        return "";
      });
    }});
    return root;
  };
  try {
    return make();
  } finally {
    Element.prototype.attachShadow = attach;
  }
}

export interface Waveform { show(sound: AudioBuffer | null): void; setColour(colour: string): void; destroy(): void }

export function makeWaveform(container: HTMLElement, height: number, colour: string): Waveform {
  const surfer = withAdoptedStyles(() => WaveSurfer.create({container, height, waveColor: colour, progressColor: colour, cursorWidth: 0,
    interact: false, hideScrollbar: true, normalize: true, barWidth: 2, barGap: 1, barRadius: 1}));
  return {
    show(sound) {
      if (!sound) surfer.empty();
      else surfer.load("", [sound.getChannelData(0)], sound.duration).catch(() => {});  // a later one came first
    },
    setColour(next) { surfer.setOptions({waveColor: next, progressColor: next}); },
    destroy() { surfer.destroy(); },
  };
}
