package org.dronemap.store.secret;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Base64;
import org.dronemap.store.StoreException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SecretBoxTest {
    private static final byte[] PLAIN = "nobody shall read this".getBytes(StandardCharsets.UTF_8);

    private final SecretBox box = new SecretBox(new byte[32]);

    @TempDir
    private Path directory;

    @Test
    void opensWhatItSealedAtItsPlaceOnly() {
        String sealed = box.seal(PLAIN, "here");
        assertThat(box.open(sealed, "here")).contains(PLAIN);
        assertThat(box.open(sealed, "there")).isEmpty();
        assertThat(box.seal(PLAIN, "here")).isNotEqualTo(sealed);
    }

    @Test
    void anyChangedByteIsNoticed() {
        byte[] sealed = Base64.getDecoder().decode(box.seal(PLAIN, "here"));
        for (int i = 0; i < sealed.length; i++) {
            byte[] changed = sealed.clone();
            changed[i] ^= 1;
            assertThat(box.open(Base64.getEncoder().encodeToString(changed), "here"))
                    .isEmpty();
        }
        assertThat(box.open("", "here")).isEmpty();
        assertThat(box.open("no base64!", "here")).isEmpty();
    }

    @Test
    void theFileIsMadeOnceForItsOwnerAlone() throws IOException {
        Path file = directory.resolve("link-secret");
        String sealed = ServerSecret.box(null, file).seal(PLAIN, "here");

        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
                .isEqualTo("rw-------");
        assertThat(ServerSecret.box(null, file).open(sealed, "here")).contains(PLAIN);
    }

    @Test
    void aGivenSecretNeedsNoFile() {
        Path file = directory.resolve("link-secret");
        String sealed = ServerSecret.box("0".repeat(64), file).seal(PLAIN, "here");

        assertThat(file).doesNotExist();
        assertThat(box.open(sealed, "here")).contains(PLAIN);
    }

    @Test
    void aWrongSecretIsRefusedWithoutShowingIt() {
        Path file = directory.resolve("link-secret");
        assertThatThrownBy(() -> ServerSecret.box("secret123", file))
                .isInstanceOf(StoreException.class)
                .hasMessageContaining("64 hexadecimal digits")
                .hasMessageNotContaining("secret123");
    }
}
