package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class RobotWebSocketPathTest {
    @Test
    void knowsTheTwoPathsOfTheBridges() {
        assertThat(RobotWebSocketPath.of("/")).contains(new RobotWebSocketPath(null, null));
        assertThat(RobotWebSocketPath.of("/websockets/roslink/user/12/robot/ab%20c/robot"))
                .contains(new RobotWebSocketPath("12", "ab c"));
    }

    @Test
    void knowsNoOthers() {
        assertThat(RobotWebSocketPath.of("/websockets/roslink/user/12/robot/ab/user"))
                .isEmpty();
        assertThat(RobotWebSocketPath.of("/websockets/roslink")).isEmpty();
        assertThat(RobotWebSocketPath.of("/?key=1")).isEmpty();
        assertThat(RobotWebSocketPath.of("/websockets/roslink/user/%zz/robot/ab/robot"))
                .isEmpty();
        assertThat(RobotWebSocketPath.of("/websockets/roslink/user/1/robot/" + "a".repeat(500) + "/robot"))
                .isEmpty();
    }
}
