package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class RobotPathTest {
    @Test
    void knowsTheTwoPathsOfTheBridges() {
        assertThat(RobotPath.of("/")).contains(new RobotPath(null, null));
        assertThat(RobotPath.of("/websockets/roslink/user/12/robot/ab%20c/robot"))
                .contains(new RobotPath("12", "ab c"));
    }

    @Test
    void knowsNoOthers() {
        assertThat(RobotPath.of("/websockets/roslink/user/12/robot/ab/user")).isEmpty();
        assertThat(RobotPath.of("/websockets/roslink")).isEmpty();
        assertThat(RobotPath.of("/?key=1")).isEmpty();
        assertThat(RobotPath.of("/websockets/roslink/user/%zz/robot/ab/robot")).isEmpty();
        assertThat(RobotPath.of("/websockets/roslink/user/1/robot/" + "a".repeat(500) + "/robot"))
                .isEmpty();
    }
}
