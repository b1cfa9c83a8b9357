package org.dronemap.ws.security;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.ws.account.InitialPassword;
import org.dronemap.ws.account.PasswordHashing;
import org.dronemap.ws.reading.SecretGenerator;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Creates the first administrator at the first start, with a generated password in a file for the machine's owner. Any
 * thread.
 */
public final class InitialAdministrator implements InitialPassword {
    private static final Logger LOG = LoggerFactory.getLogger(InitialAdministrator.class);
    static final String ADMIN = "admin";
    private static final String CLOSED = "This server is open to the network and still has its first administrator"
            + " password; sign in as " + ADMIN + " and change it, then everything works.";

    private final Path passwordFile;
    private final boolean publicMode;
    private volatile boolean pending;

    private InitialAdministrator(Path passwordFile, boolean publicMode, boolean pending) {
        this.passwordFile = passwordFile;
        this.publicMode = publicMode;
        this.pending = pending;
    }

    /** Sees to it that there is an administrator, and that the first password can be found while it is needed. */
    public static InitialAdministrator prepare(
            AccessStore store,
            PasswordHashing passwords,
            SecretGenerator secrets,
            Path dataDirectory,
            boolean publicMode) {
        Path file = dataDirectory.resolve("first-password.txt");
        Optional<User> admin = store.user(ADMIN);
        boolean nobody = store.users().stream().noneMatch(user -> user.role() == Role.ADMINISTRATOR && user.isActive());
        boolean unchanged = admin.map(User::mustChangePassword).orElse(false);
        if (nobody || (unchanged && !Files.exists(file))) {
            String password = secrets.password();
            User user = new User(ADMIN, Role.ADMINISTRATOR, AccountState.ACTIVE, passwords.hash(password), true);
            if (!store.addUser(user)) {
                store.updateUser(user);
            }
            OwnerOnlyFiles.write(file, ADMIN + " " + password + "\n");
            LOG.info("The first administrator password lies in {}", file);
            unchanged = true;
        }
        return new InitialAdministrator(file, publicMode, unchanged);
    }

    /** A new key for whoever can read the data directory; the one before is void. */
    public static String localKey(SecretGenerator secrets, Path dataDirectory) {
        String key = secrets.token();
        OwnerOnlyFiles.write(dataDirectory.resolve("local-key"), key + "\n");
        return key;
    }

    @Override
    public Optional<String> closed() {
        return publicMode && pending ? Optional.of(CLOSED) : Optional.empty();
    }

    @Override
    public boolean mayStay(String user) {
        return !publicMode && pending && user.equals(ADMIN);
    }

    @Override
    public void changed(String user) {
        if (!user.equals(ADMIN)) {
            return;
        }
        pending = false;
        try {
            Files.deleteIfExists(passwordFile);
        } catch (IOException e) {
            throw new UncheckedIOException("cannot remove " + passwordFile, e);
        }
    }
}
