package org.dronemap.core.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CompletionException;
import org.junit.jupiter.api.Test;

class FatalErrorsTest {
    @Test
    void findsWhatALibraryWrapped() {
        OutOfMemoryError error = new OutOfMemoryError("no threads");

        assertThat(FatalErrors.behind(new IllegalStateException(new CompletionException(error))))
                .contains(error);
        assertThat(FatalErrors.behind(error)).contains(error);
        assertThat(FatalErrors.behind(new Exception(new ThreadDeath()))).isPresent();
    }

    @Test
    void leavesAloneWhatIsOverWithTheCall() {
        assertThat(FatalErrors.behind(new IllegalStateException(new StackOverflowError())))
                .isEmpty();
        assertThat(FatalErrors.behind(new IllegalStateException(new AssertionError("a fault of one call"))))
                .isEmpty();
        assertThat(FatalErrors.behind(new IllegalArgumentException("plain"))).isEmpty();
    }
}
