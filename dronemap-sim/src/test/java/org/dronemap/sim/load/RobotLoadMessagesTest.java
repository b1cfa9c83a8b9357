package org.dronemap.sim.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** What load robots say: where each of them is tells who it is and how far it has come. */
class RobotLoadMessagesTest {
    @Test
    void saysWhoItIsAndWhichStepItIsAt() {
        RobotLoadMessages words = new RobotLoadMessages(42, 10);
        List<JsonNode> said = IntStream.range(0, 20)
                .mapToObj(step -> JsonMapper.shared().readTree(words.next()))
                .toList();
        JsonNode farewell = JsonMapper.shared().readTree(words.motion());

        assertThat(said)
                .extracting(
                        message -> message.get("header").get("sequence_number").intValue())
                .containsExactlyElementsOf(IntStream.rangeClosed(1, 20).boxed().toList());
        assertThat(said)
                .extracting(message -> message.get("header").get("message_id").intValue())
                .containsSubsequence(0, 4, 2, 2, 2, 2, 2, 2, 2, 2, 0, 4, 2);
        assertThat(said.get(1).get("ranges")).hasSize(360);
        assertThat(said.get(19).get("x").intValue()).isEqualTo(19);
        assertThat(farewell.get("x").intValue()).isEqualTo(20);
        assertThat(farewell.get("y").intValue()).isEqualTo(42);
        assertThat(farewell.get("header").get("system_id").intValue()).isEqualTo(1_042);
    }
}
