// A film of what is drawn, frame by frame: WebM with VP9 and Opus, by the browser's own encoders.
import {AudioBufferSource, BufferTarget, canEncodeAudio, canEncodeVideo, CanvasSource, Output, QUALITY_HIGH, WebMOutputFormat} from "mediabunny";

export const filmFps = 30;

export const canFilm = async (width: number, height: number): Promise<boolean> =>
    typeof VideoEncoder !== "undefined" && await canEncodeVideo("vp9", {width, height}) && await canEncodeAudio("opus", {numberOfChannels: 1, sampleRate: 48000});

export interface Film {
  readonly canvas: HTMLCanvasElement;
  readonly sound: AudioBuffer;
  readonly duration_s: number;
  draw(time_s: number): void;  // onto the canvas, at once
  progress(share: number): void;
  readonly stop: AbortSignal;
}

// The file's bytes; null where it was stopped. The last frame ends with the sound.
export async function film({canvas, sound, duration_s, draw, progress, stop}: Film): Promise<ArrayBuffer | null> {
  const target = new BufferTarget();
  const output = new Output({format: new WebMOutputFormat(), target});
  const pictures = new CanvasSource(canvas, {codec: "vp9", bitrate: QUALITY_HIGH});
  const heard = new AudioBufferSource({codec: "opus", bitrate: 96_000});
  output.addVideoTrack(pictures, {frameRate: filmFps});
  output.addAudioTrack(heard);
  await output.start();
  await heard.add(sound);
  heard.close();
  const count = Math.max(1, Math.ceil(duration_s * filmFps - 1e-6));
  for (let k = 0; k < count; ++k) {
    if (stop.aborted) {
      await output.cancel();
      return null;
    }
    const time_s = k / filmFps;
    draw(time_s);
    await pictures.add(time_s, Math.min(1 / filmFps, duration_s - time_s));
    progress((k + 1) / count);
    // The page goes on: a press of Cancel is heard.
    await new Promise(resolve => setTimeout(resolve, 0));
  }
  pictures.close();
  await output.finalize();
  return target.buffer;
}
