package org.dronemap.sim.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

/** The room, its map and what is measured in it say the same. */
class SimulatedRoomTest {
    @Test
    void measuresTheWallsAndTheBox() {
        assertThat(SimulatedRoom.range(0, 0, 0, 10)).isCloseTo(3.8, within(0.02));
        assertThat(SimulatedRoom.range(0, 0, Math.PI / 2, 10)).isCloseTo(2.8, within(0.02));
        assertThat(SimulatedRoom.range(0, 1, 0, 10)).isCloseTo(1.5, within(0.02));
        assertThat(SimulatedRoom.range(0, 0, 0, 1)).isEqualTo(1);
    }

    @Test
    void drawsOnItsMapWhatIsSolidWithYUpwards() throws IOException {
        BufferedImage map = ImageIO.read(new ByteArrayInputStream(SimulatedRoom.map()));

        assertThat(map.getWidth() * SimulatedRoom.CELL).isEqualTo(SimulatedRoom.WIDTH);
        assertThat(map.getHeight() * SimulatedRoom.CELL).isEqualTo(SimulatedRoom.HEIGHT);
        assertThat(isBlack(map, 2, 1)).isTrue();
        assertThat(isBlack(map, 2, -1)).isFalse();
        assertThat(isBlack(map, 0, 2.95)).isTrue();
        assertThat(isBlack(map, 0, 0)).isFalse();
    }

    private static boolean isBlack(BufferedImage map, double x, double y) {
        int column = (int) ((x + SimulatedRoom.WIDTH / 2) / SimulatedRoom.CELL);
        int row = (int) ((SimulatedRoom.HEIGHT / 2 - y) / SimulatedRoom.CELL);
        return (map.getRGB(column, row) & 0xff) == 0;
    }
}
