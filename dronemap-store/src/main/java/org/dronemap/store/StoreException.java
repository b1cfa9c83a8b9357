package org.dronemap.store;

import org.jspecify.annotations.Nullable;

/** Something could not be kept or found; the message is a sentence for the person who runs the server. */
public final class StoreException extends RuntimeException {
    public StoreException(String sentence) {
        super(sentence);
    }

    public StoreException(String sentence, @Nullable Throwable cause) {
        super(sentence, cause);
    }
}
