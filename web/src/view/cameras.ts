// Where the avatar is seen from: its sides, and with the eyes of a participant of the studies.
import type {Point} from "../model/posing.ts";

export type Camera = "front" | "left" | "right" | "top" | "across" | "beside";

// In the order of the menu and of the keys 1 to 6.
export const cameras: readonly (readonly [Camera, string])[] = [["front", "Front"], ["left", "Left"], ["right", "Right"], ["top", "Above"],
  ["across", "Across"], ["beside", "Side by side"]];

// From which side the upper body is looked at.
export const sides: Partial<Record<Camera, Point>> = {front: [0, 0.06, 1], left: [1, 0.06, 0.05], right: [-1, 0.06, 0.05], top: [0, 1, 0.35]};

// The studies' layouts at a desktop: metres on the floor, and where one faces; 0 is along +z, as the avatar does.
export const places: Partial<Record<Camera, {readonly viewer_m: readonly [x: number, z: number]; readonly heading_deg: number}>> = {
  across: {viewer_m: [0, 3.4], heading_deg: 180}, beside: {viewer_m: [-1.2, -1], heading_deg: 20}};
export const eyeHeight_m = 1.65;
const widePicture = 16 / 9;
const leastView_deg = 60;

// How high a participant's view is: as in a picture of 16 to 9, higher where the picture is narrower.
export const viewOf_deg = (aspect: number): number => {
  const half = leastView_deg / 2 * Math.PI / 180;
  return 2 * 180 / Math.PI * Math.atan(Math.tan(half) * Math.max(1, widePicture / aspect));
};
