import type { Sensed, SensedNumbers } from '../api/sensed';
import type { LocalPosition } from '../api/types';

export interface Point {
  x: number;
  y: number;
}

/** The part of a vehicle's own frame that is drawn, in metres. */
export interface Frame {
  left: number;
  bottom: number;
  width: number;
  height: number;
}

const LEAST_METERS = 4;
const MARGIN = 1.15;

export const NOTHING_YET = '';

/** Another word whenever one of the sensors brought something new. */
export function newestOf(numbers: SensedNumbers | null | undefined): string {
  const { scan = null, picture = null, map = null } = numbers ?? {};
  const brought = [scan, picture, map].some((number) => number !== null);
  return brought ? `${scan ?? 0}/${picture ?? 0}/${map ?? 0}` : NOTHING_YET;
}

/** The map where there is one, else all that is known around the vehicle. */
export function frameOf(map: Frame | null, local: LocalPosition | null, hits: Point[]): Frame {
  if (map !== null) {
    const { left, bottom, width, height } = map;
    return { left, bottom, width, height };
  }
  const middle = local ?? { x: 0, y: 0 };
  const reach = hits.map((hit) => Math.max(Math.abs(hit.x - middle.x), Math.abs(hit.y - middle.y)));
  const size = 2 * MARGIN * Math.max(LEAST_METERS / 2, ...reach);
  return { left: middle.x - size / 2, bottom: middle.y - size / 2, width: size, height: size };
}

/** The hits of a sweep in the frame of the vehicle's map; none without its heading. */
export function hitsOf(scan: Sensed['scan'], local: LocalPosition | null): Point[] {
  if (scan === null || local === null || local.yaw === null) {
    return [];
  }
  const yaw = local.yaw;
  return scan.ranges.flatMap((range, index) => {
    if (range === null) {
      return [];
    }
    const angle = ((yaw + scan.firstAngle + index * scan.angleStep) * Math.PI) / 180;
    return [{ x: local.x + range * Math.cos(angle), y: local.y + range * Math.sin(angle) }];
  });
}

/** Pixels a metre, the same along both axes, and where the frame's corner lies. */
export class Projection {
  readonly #frame: Frame;
  readonly #height: number;
  readonly scale: number;

  constructor(frame: Frame, width: number, height: number) {
    this.#frame = frame;
    this.#height = height;
    this.scale = Math.min(width / frame.width, height / frame.height);
  }

  toPixels(point: Point): Point {
    return {
      x: (point.x - this.#frame.left) * this.scale,
      y: this.#height - (point.y - this.#frame.bottom) * this.scale,
    };
  }

  toMeters(pixels: Point): Point {
    return {
      x: this.#frame.left + pixels.x / this.scale,
      y: this.#frame.bottom + (this.#height - pixels.y) / this.scale,
    };
  }
}

export interface Scene {
  frame: Frame;
  map: { image: CanvasImageSource; frame: Frame } | null;
  hits: Point[];
  local: LocalPosition | null;
  target: Point | null;
}

export interface Colours {
  ground: string;
  hit: string;
  vehicle: string;
  target: string;
}

const HIT_PIXELS = 3;
const VEHICLE_PIXELS = 9;
const TARGET_PIXELS = 7;

/** Draws it all anew. */
export function draw(context: CanvasRenderingContext2D, scene: Scene, colours: Colours): void {
  const { width, height } = context.canvas;
  const projection = new Projection(scene.frame, width, height);
  context.fillStyle = colours.ground;
  context.fillRect(0, 0, width, height);
  if (scene.map !== null) {
    const { frame, image } = scene.map;
    const corner = projection.toPixels({ x: frame.left, y: frame.bottom + frame.height });
    context.imageSmoothingEnabled = false;
    context.drawImage(
      image,
      corner.x,
      corner.y,
      frame.width * projection.scale,
      frame.height * projection.scale,
    );
  }
  context.fillStyle = colours.hit;
  for (const hit of scene.hits) {
    const { x, y } = projection.toPixels(hit);
    context.fillRect(x - HIT_PIXELS / 2, y - HIT_PIXELS / 2, HIT_PIXELS, HIT_PIXELS);
  }
  if (scene.target !== null) {
    drawTarget(context, projection.toPixels(scene.target), colours.target);
  }
  if (scene.local !== null) {
    drawVehicle(context, projection.toPixels(scene.local), scene.local.yaw, colours.vehicle);
  }
}

function drawTarget(context: CanvasRenderingContext2D, at: Point, colour: string): void {
  context.strokeStyle = colour;
  context.lineWidth = 3;
  context.beginPath();
  context.arc(at.x, at.y, TARGET_PIXELS, 0, 2 * Math.PI);
  context.stroke();
}

/** A dot where it does not say how it stands. */
function drawVehicle(context: CanvasRenderingContext2D, at: Point, yaw: number | null, colour: string): void {
  context.fillStyle = colour;
  context.beginPath();
  if (yaw === null) {
    context.arc(at.x, at.y, VEHICLE_PIXELS / 2, 0, 2 * Math.PI);
  } else {
    [0, 140, 220].forEach((turn) => {
      const angle = ((yaw + turn) * Math.PI) / 180;
      context.lineTo(at.x + VEHICLE_PIXELS * Math.cos(angle), at.y - VEHICLE_PIXELS * Math.sin(angle));
    });
  }
  context.fill();
}
