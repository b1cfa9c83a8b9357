package org.dronemap.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.mavlink.message.ControlStatus;
import org.junit.jupiter.api.Test;

/** A message that no library here knows: its checksum seed comes from its definition. */
class ControlStatusTest {
    @Test
    void theChecksumSeedIsThatOfTheDefinition() {
        String fields = "CONTROL_STATUS uint8_t flags uint8_t gcs_main uint8_t gcs_secondary ";
        byte[] text = fields.getBytes(StandardCharsets.US_ASCII);
        int crc = Crc.add(Crc.add(Crc.START, text, 0, text.length), 10);
        int seed = (crc & 0xFF) ^ (crc >> 8);
        assertThat(MessageTable.find(ControlStatus.ID))
                .isEqualTo(new MessageTable.Entry(512, "ControlStatus", seed, 12, 12, -1));
    }

    @Test
    void whatIsWrittenIsReadAsItWas() {
        List<Frame> read = new ArrayList<>();
        byte[] frame = new FrameWriter(1, 1, 2).frame(new ControlStatus(3, 254));
        new FrameReader().read(ByteBuffer.wrap(frame), read::add);
        assertThat(read).hasSize(1);
        assertThat(ControlStatus.decode(read.get(0))).isEqualTo(new ControlStatus(3, 254));
    }
}
