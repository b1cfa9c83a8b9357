package org.dronemap.core.drone;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** What has to be put back, when several set a height one after the other. */
class ReturnHeightTest {
    private static final ReturnHeight SET = new ReturnHeight(32, 15);

    @Test
    void theFirstOneCountsAsItIs() {
        assertThat(SET.after(null)).isEqualTo(SET);
    }

    @Test
    void oneSetOverAnotherThatWasNotPutBackKeepsWhatTheOwnerHad() {
        assertThat(new ReturnHeight(44, 32).after(SET)).isEqualTo(new ReturnHeight(44, 15));
        assertThat(new ReturnHeight(32, 32).after(SET)).isEqualTo(SET);
    }

    @Test
    void whatWasPutBackIsTheOwnersAgain() {
        ReturnHeight back = new ReturnHeight(15, 32).after(SET);
        assertThat(back).isEqualTo(new ReturnHeight(15, 15));
        assertThat(new ReturnHeight(26, 15).after(back)).isEqualTo(new ReturnHeight(26, 15));
    }

    @Test
    void whatTheOwnerHasSetMeanwhileIsPutBack() {
        assertThat(new ReturnHeight(44, 60).after(SET)).isEqualTo(new ReturnHeight(44, 60));
    }
}
