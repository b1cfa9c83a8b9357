package org.dronemap.core.link;

import java.util.List;
import org.dronemap.core.drone.DroneId;

/**
 * Stores endpoints that administrators added, DTLS keys and robot keys; every write returns only after it is durable.
 */
public interface EndpointStore {
    /** In the order in which they were added. */
    List<SavedEndpoint> links();

    /** False when the id or the URL is taken. */
    boolean addLink(SavedEndpoint link);

    /** True when there was one. */
    boolean deleteLink(String id);

    /** By the time they were made. */
    List<DtlsKey> keys();

    /** Inserts, or replaces the key of the same identity. */
    void saveKey(DtlsKey key);

    /** True when there was one. */
    boolean deleteKey(String identity);

    /** By the time they were made. */
    List<RobotKey> robotKeys();

    /** Inserts, or replaces the key of the same drone. */
    void saveRobotKey(RobotKey key);

    /** True when there was one. */
    boolean deleteRobotKey(DroneId drone);
}
