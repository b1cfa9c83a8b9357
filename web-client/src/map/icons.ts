import type { Palette } from './palette';

const RATIO = 2;

interface Drawing {
  size: number;
  draw: (context: CanvasRenderingContext2D) => void;
}

/** Draws the image that a map layer asks for by name; null for a name that is not ours. */
export function drawIcon(name: string, palette: Palette): ImageData | null {
  const drawing = drawingOf(name, palette);
  if (drawing === null) {
    return null;
  }
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = drawing.size * RATIO;
  const context = canvas.getContext('2d');
  if (context === null) {
    return null;
  }
  context.scale(RATIO, RATIO);
  context.translate(drawing.size / 2, drawing.size / 2);
  drawing.draw(context);
  return context.getImageData(0, 0, canvas.width, canvas.height);
}

export const ICON_RATIO = RATIO;

function drawingOf(name: string, palette: Palette): Drawing | null {
  const [what, shape, tone = 'neutral', mark] = name.split('|');
  switch (what) {
    case 'drone':
      return droneDrawing(shape === 'arrow', colourOf(tone, palette), mark === 'crossed', palette);
    case 'phone':
      return { size: 30, draw: (context) => drawPhone(context, colourOf(tone, palette), palette) };
    case 'home':
      return { size: 26, draw: (context) => drawHome(context, palette) };
    case 'target':
      return { size: 32, draw: (context) => drawTarget(context, palette) };
    default:
      return null;
  }
}

function colourOf(tone: string, palette: Palette): string {
  const { green, amber, red, blue, violet } = palette;
  const tones: Record<string, string> = { green, amber, red, blue, violet };
  return tones[tone] ?? palette.neutral;
}

function droneDrawing(arrow: boolean, colour: string, crossed: boolean, palette: Palette): Drawing {
  return {
    size: 40,
    draw: (context) => {
      context.beginPath();
      context.arc(0, 0, 16, 0, 2 * Math.PI);
      context.fillStyle = palette.surface;
      context.fill();
      context.lineWidth = 3;
      context.strokeStyle = colour;
      context.stroke();
      context.fillStyle = colour;
      context.beginPath();
      if (arrow) {
        context.moveTo(0, -10);
        context.lineTo(7, 7);
        context.lineTo(0, 3.5);
        context.lineTo(-7, 7);
        context.closePath();
        context.fill();
      } else {
        context.arc(0, 0, 4.5, 0, 2 * Math.PI);
        context.fill();
      }
      if (crossed) {
        drawCross(context, colour, palette);
      }
    },
  };
}

function drawCross(context: CanvasRenderingContext2D, colour: string, palette: Palette): void {
  for (const [width, style] of [
    [6, palette.surface],
    [3, colour],
  ] as const) {
    context.lineWidth = width;
    context.strokeStyle = style;
    context.beginPath();
    context.moveTo(-11, -11);
    context.lineTo(11, 11);
    context.moveTo(11, -11);
    context.lineTo(-11, 11);
    context.stroke();
  }
}

/** A person seen from above, in a ring. */
function drawPhone(context: CanvasRenderingContext2D, colour: string, palette: Palette): void {
  context.beginPath();
  context.arc(0, 0, 13, 0, 2 * Math.PI);
  context.fillStyle = palette.surface;
  context.fill();
  context.beginPath();
  context.arc(0, 0, 10, 0, 2 * Math.PI);
  context.fillStyle = colour;
  context.fill();
  context.fillStyle = palette.surface;
  context.beginPath();
  context.arc(0, -2.6, 2.9, 0, 2 * Math.PI);
  context.fill();
  context.beginPath();
  context.arc(0, 6.2, 5, Math.PI, 2 * Math.PI);
  context.fill();
}

function drawHome(context: CanvasRenderingContext2D, palette: Palette): void {
  context.beginPath();
  context.arc(0, 0, 11, 0, 2 * Math.PI);
  context.fillStyle = palette.surface;
  context.fill();
  context.lineWidth = 1.5;
  context.strokeStyle = palette.neutral;
  context.stroke();
  context.fillStyle = palette.neutral;
  context.beginPath();
  context.moveTo(0, -6.5);
  context.lineTo(6.5, -0.5);
  context.lineTo(4.5, -0.5);
  context.lineTo(4.5, 5);
  context.lineTo(-4.5, 5);
  context.lineTo(-4.5, -0.5);
  context.lineTo(-6.5, -0.5);
  context.closePath();
  context.fill();
}

function drawTarget(context: CanvasRenderingContext2D, palette: Palette): void {
  for (const [width, style] of [
    [5, palette.surface],
    [2, palette.violet],
  ] as const) {
    context.lineWidth = width;
    context.strokeStyle = style;
    context.beginPath();
    context.arc(0, 0, 8, 0, 2 * Math.PI);
    context.moveTo(0, -14);
    context.lineTo(0, -4);
    context.moveTo(0, 4);
    context.lineTo(0, 14);
    context.moveTo(-14, 0);
    context.lineTo(-4, 0);
    context.moveTo(4, 0);
    context.lineTo(14, 0);
    context.stroke();
  }
}
