package org.dronemap.ws.control;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ControlStreamOperationTest {
    @Test
    void isJudgedAsAnOperationOfItsOwnForEachAction() {
        assertThat(ControlStreamOperation.BY_ACTION.keySet()).containsExactlyInAnyOrder(ControlAction.values());
        assertThat(ControlStreamOperation.BY_ACTION.values()).doesNotHaveDuplicates();
    }
}
