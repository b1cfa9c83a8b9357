package org.dronemap.core.zone;

import java.util.List;

/** Stores zones; every write returns only after it is durable. */
public interface ZoneStore {
    /** All of them by name. */
    List<Zone> zones();

    /** Inserts or replaces all of them, or none. */
    void save(List<Zone> zones);

    /** True when there was one. */
    boolean delete(String id);
}
