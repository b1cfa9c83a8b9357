package org.dronemap.proxy.outlet.rights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** From where a personal port may be spoken to. */
class AddressRangeTest {
    @ParameterizedTest
    @CsvSource({
        "192.0.2.7, 192.0.2.7, true",
        "192.0.2.7, 192.0.2.8, false",
        "192.0.2.77/24, 192.0.2.255, true",
        "192.0.2.0/24, 192.0.3.0, false",
        "192.0.2.128/25, 192.0.2.127, false",
        "192.0.2.128/25, 192.0.2.128, true",
        "192.0.2.7, 2001:db8::7, false",
        "2001:db8::/64, 2001:db8:0:0:1:2:3:4, true",
        "2001:db8::/64, 2001:db8:0:1:1:2:3:4, false",
        "fe80::1, fe80:0:0:0:0:0:0:1%eth0, true",
    })
    void holdsWhatBeginsAlike(String range, String host, boolean inside) {
        assertThat(AddressRange.parse(range).contains(host)).isEqualTo(inside);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "", "localhost", "example.org", "192.0.2", "192.0.2.300", "192.0.2.0/23", "192.0.2.0/33", "0.0.0.0/24",
                "::/64", "2001:db8::/63", "::1/129", "192.0.2.0/-1", "192.0.2.7:14550", "1234", "..", "cafe"
            })
    void isNumbersAndSmall(String text) {
        assertThatIllegalArgumentException().isThrownBy(() -> AddressRange.parse(text));
    }

    @Test
    void tellsItsNetwork() {
        assertThat(AddressRange.parse("192.0.2.77/24")).hasToString("192.0.2.0/24");
        assertThat(AddressRange.parse(" 192.0.2.77 ")).hasToString("192.0.2.77");
    }
}
