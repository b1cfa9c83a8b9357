package org.dronemap.ws.account;

/** Turns passwords into salted hashes and checks them. */
public interface PasswordHashing {
    String hash(String password);

    boolean matches(String password, String hash);
}
