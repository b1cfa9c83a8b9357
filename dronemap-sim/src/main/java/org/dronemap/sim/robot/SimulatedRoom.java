package org.dronemap.sim.robot;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import javax.imageio.ImageIO;

/** The room in which simulated ground robots drive: 8 m by 6 m, walls 0.2 m thick, and a box in it. Metres. */
public final class SimulatedRoom {
    public static final double WIDTH = 8;
    public static final double HEIGHT = 6;
    /** Of a pixel of its map. */
    public static final double CELL = 0.05;

    private static final double WALL = 0.2;
    private static final double BOX_LEFT = 1.5;
    private static final double BOX_RIGHT = 2.5;
    private static final double BOX_BOTTOM = 0.5;
    private static final double BOX_TOP = 1.5;
    private static final double RAY_STEP = 0.01;
    private static final int FREE = 0xfefefe;
    private static final int SOLID = 0x000000;

    private SimulatedRoom() {}

    /** Something stands there, or it is outside. */
    public static boolean isSolid(double x, double y) {
        boolean wall = Math.abs(x) > WIDTH / 2 - WALL || Math.abs(y) > HEIGHT / 2 - WALL;
        boolean box = x >= BOX_LEFT && x <= BOX_RIGHT && y >= BOX_BOTTOM && y <= BOX_TOP;
        return wall || box;
    }

    /** How far one sees from there, at most so far; the angle counter-clockwise from x, in radians. */
    public static double range(double x, double y, double angle, double most) {
        double way = 0;
        while (way < most && !isSolid(x + way * Math.cos(angle), y + way * Math.sin(angle))) {
            way += RAY_STEP;
        }
        return Math.min(way, most);
    }

    /** Its map as a PNG: black is solid, the upper edge is the largest y. */
    public static byte[] map() {
        int columns = (int) Math.round(WIDTH / CELL);
        int rows = (int) Math.round(HEIGHT / CELL);
        BufferedImage image = new BufferedImage(columns, rows, BufferedImage.TYPE_INT_RGB);
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                double x = -WIDTH / 2 + (column + 0.5) * CELL;
                double y = HEIGHT / 2 - (row + 0.5) * CELL;
                image.setRGB(column, row, isSolid(x, y) ? SOLID : FREE);
            }
        }
        return png(image);
    }

    /** What a camera sees from there: what is nearer is taller and brighter, under a blue sky on brown ground. */
    static byte[] view(double x, double y, double yaw) {
        int width = 160;
        int height = 120;
        double opening = Math.toRadians(60);
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int column = 0; column < width; column++) {
            double angle = yaw + opening * (0.5 - (column + 0.5) / width);
            double range = Math.max(0.1, range(x, y, angle, 10));
            int half = (int) Math.min(height / 2.0, 40 / range);
            int shade = (int) (230 / (1 + 0.3 * range));
            for (int row = 0; row < height; row++) {
                boolean wall = Math.abs(row - height / 2) <= half;
                int sky = row < height / 2 ? 0x3070c0 : 0x705030;
                image.setRGB(column, row, wall ? shade << 16 | shade << 8 | shade : sky);
            }
        }
        return png(image);
    }

    private static byte[] png(BufferedImage image) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try {
            ImageIO.write(image, "png", bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }
}
