package org.dronemap.proxy.session;

import org.dronemap.core.cloud.VehicleChannel;
import org.dronemap.proxy.mavlink.procedure.ExchangeObserver;

/** Reports the progress of an exchange with a vehicle to whoever gave the command. */
record ReportingObserver(VehicleChannel.Report report) implements ExchangeObserver {
    @Override
    public void accepted() {
        report.accepted();
    }

    @Override
    public void progress(int done, int total) {
        report.progress(done, total);
    }
}
