package org.dronemap.sim.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

/** The room, its map and what is measured in it say the same. */
class RoomTest {
    @Test
    void measuresTheWallsAndTheBox() {
        assertThat(Room.range(0, 0, 0, 10)).isCloseTo(3.8, within(0.02));
        assertThat(Room.range(0, 0, Math.PI / 2, 10)).isCloseTo(2.8, within(0.02));
        assertThat(Room.range(0, 1, 0, 10)).isCloseTo(1.5, within(0.02));
        assertThat(Room.range(0, 0, 0, 1)).isEqualTo(1);
    }

    @Test
    void drawsOnItsMapWhatIsSolidWithYUpwards() throws IOException {
        BufferedImage map = ImageIO.read(new ByteArrayInputStream(Room.map()));

        assertThat(map.getWidth() * Room.CELL).isEqualTo(Room.WIDTH);
        assertThat(map.getHeight() * Room.CELL).isEqualTo(Room.HEIGHT);
        assertThat(isBlack(map, 2, 1)).isTrue();
        assertThat(isBlack(map, 2, -1)).isFalse();
        assertThat(isBlack(map, 0, 2.95)).isTrue();
        assertThat(isBlack(map, 0, 0)).isFalse();
    }

    private static boolean isBlack(BufferedImage map, double x, double y) {
        int column = (int) ((x + Room.WIDTH / 2) / Room.CELL);
        int row = (int) ((Room.HEIGHT / 2 - y) / Room.CELL);
        return (map.getRGB(column, row) & 0xff) == 0;
    }
}
