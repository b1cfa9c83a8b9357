package org.dronemap.store.memory;

import org.dronemap.core.command.CommandStore;
import org.dronemap.store.contract.CommandStoreContract;

class MemoryCommandStoreTest extends CommandStoreContract {
    @Override
    protected CommandStore emptyStore() {
        return new MemoryCommandStore();
    }
}
