package org.dronemap.core.stored;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class StoredNamesTest {
    /** Both were called otherwise once. */
    @Stored(names = "UP DOWN")
    private enum Phase {
        RISEN {
            @Override
            boolean isHigh() {
                return true;
            }
        },
        LANDED;

        boolean isHigh() {
            return false;
        }
    }

    @Stored(as = "Moved", names = "north east")
    private record Shifted(double northMeters, double eastMeters) {}

    @Stored
    private record Nothing() {}

    private record Unnamed(int one) {}

    @Stored(names = "one")
    private record TooFew(int one, int two) {}

    @Stored(names = "one one")
    private record Twice(int one, int two) {}

    @Stored(names = "one two")
    private record Swapped(int two, int one) {}

    @Stored(names = "ONE TWO")
    private enum SwappedConstants {
        TWO,
        ONE
    }

    @Test
    void constantsGoByTheirStoredNames() {
        assertThat(StoredNames.of(Phase.RISEN)).isEqualTo("UP");
        assertThat(Phase.RISEN.isHigh()).isTrue();
        assertThat(StoredNames.constant(Phase.class, "DOWN")).isEqualTo(Phase.LANDED);
    }

    @Test
    void namesOfTheCodeAreNone() {
        assertThatThrownBy(() -> StoredNames.constant(Phase.class, "RISEN"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("there is no RISEN among [UP, DOWN]");
    }

    @Test
    void recordsGoByTheirStoredNames() {
        assertThat(StoredNames.of(Shifted.class)).isEqualTo("Moved");
        assertThat(StoredNames.ofParts(Shifted.class)).containsExactly("north", "east");
        assertThat(StoredNames.ofParts(Nothing.class)).isEmpty();
    }

    @Test
    void whatTellsNothingApartIsRefused() {
        assertThatThrownBy(() -> StoredNames.of(Nothing.class))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("Nothing needs @Stored(as");
    }

    @ParameterizedTest
    @ValueSource(classes = {Unnamed.class, TooFew.class, Twice.class, Swapped.class, SwappedConstants.class})
    void whatIsNotNamedPartByPartIsRefused(Class<?> type) {
        assertThatThrownBy(() -> StoredNames.ofParts(type))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining(type.getName());
    }
}
