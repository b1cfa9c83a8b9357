package org.dronemap.store.file;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.DateTimeException;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.audit.AuditHead;
import org.dronemap.core.audit.AuditHeadStore;
import org.dronemap.core.audit.SignedAuditHead;
import org.dronemap.core.stored.StoredNames;
import org.dronemap.store.StoreException;

/**
 * Stores the signed heads of the audit log, outside of the database, in a file that is only appended to. Any thread.
 */
public final class FileAuditHeadStore implements AuditHeadStore {
    private final Path file;

    public FileAuditHeadStore(Path file) {
        this.file = file;
    }

    @Override
    public synchronized Optional<List<Optional<SignedAuditHead>>> all() {
        try {
            return Optional.of(Files.readString(file, StandardCharsets.ISO_8859_1)
                    .lines()
                    .map(FileAuditHeadStore::read)
                    .toList());
        } catch (NoSuchFileException e) {
            return Optional.empty();
        } catch (IOException e) {
            throw new StoreException("The heads of the audit log in " + file + " cannot be read: " + e.getMessage(), e);
        }
    }

    @Override
    public synchronized void add(SignedAuditHead head) {
        try (FileChannel channel = FileChannel.open(
                file,
                Set.of(StandardOpenOption.CREATE, StandardOpenOption.APPEND),
                PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rw-------")))) {
            ByteBuffer line = ByteBuffer.wrap((write(head) + "\n").getBytes(StandardCharsets.ISO_8859_1));
            while (line.hasRemaining()) {
                channel.write(line);
            }
            channel.force(true);
        } catch (IOException e) {
            throw new StoreException("The head of the audit log cannot be kept in " + file + ": " + e.getMessage(), e);
        }
    }

    private static String write(SignedAuditHead signed) {
        String hash = signed.head().hash();
        return String.join(
                " ",
                StoredNames.of(signed.kind()).toLowerCase(Locale.ROOT),
                String.valueOf(signed.head().sequence()),
                hash.isEmpty() ? "-" : hash,
                signed.at().toString(),
                signed.signature());
    }

    private static Optional<SignedAuditHead> read(String line) {
        String[] parts = line.split(" ", -1);
        if (parts.length != 5) {
            return Optional.empty();
        }
        try {
            AuditHead head = new AuditHead(Long.parseLong(parts[1]), parts[2].equals("-") ? "" : parts[2]);
            SignedAuditHead signed = new SignedAuditHead(
                    StoredNames.constant(SignedAuditHead.Kind.class, parts[0].toUpperCase(Locale.ROOT)),
                    head,
                    Instant.parse(parts[3]),
                    parts[4]);
            return Optional.of(signed).filter(one -> write(one).equals(line));
        } catch (DateTimeException | IllegalArgumentException e) {
            return Optional.empty();
        }
    }
}
