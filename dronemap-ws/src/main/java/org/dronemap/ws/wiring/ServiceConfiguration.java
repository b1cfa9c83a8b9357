package org.dronemap.ws.wiring;

import java.nio.file.Path;
import java.time.Clock;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.history.TrackWriter;
import org.dronemap.core.time.Time;
import org.dronemap.store.parquet.ParquetTrackWriter;
import org.dronemap.ws.account.AccountChanges;
import org.dronemap.ws.account.ExternalUsers;
import org.dronemap.ws.account.InitialPassword;
import org.dronemap.ws.account.PasswordHashing;
import org.dronemap.ws.budget.Budgets;
import org.dronemap.ws.drone.DronePlaceNames;
import org.dronemap.ws.place.PlaceNames;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.reading.SecretGenerator;
import org.dronemap.ws.security.CallerAuthenticator;
import org.dronemap.ws.security.CurrentPrincipal;
import org.dronemap.ws.security.InitialAdministrator;
import org.dronemap.ws.security.oidc.OidcSettings;
import org.dronemap.ws.security.oidc.OidcSignIn;
import org.dronemap.ws.server.BuildVersion;
import org.dronemap.ws.server.DroneIdGenerator;
import org.dronemap.ws.settings.ServerSettings;
import org.dronemap.ws.system.SystemService;
import org.dronemap.ws.user.RegistrationPolicy;
import org.jspecify.annotations.Nullable;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;

/**
 * Spring configuration of the sign-in, of what all rooms share, and of what they take from settings, stores and places,
 * which they do not see.
 */
@Configuration(proxyBeanMethods = false)
class ServiceConfiguration {

    @Bean
    SecretGenerator secrets() {
        return new SecretGenerator();
    }

    @Bean
    InitialPassword firstPassword(
            AccessStore users, PasswordHashing passwords, SecretGenerator secrets, ServerSettings settings) {
        return InitialAdministrator.prepare(users, passwords, secrets, settings.dataDirectory(), settings.publicMode());
    }

    @Bean
    CallerAuthenticator authentication(
            AccessStore users, InitialPassword firstPassword, CallerAuthenticator.Verifiers verifiers, Clock clock) {
        return new CallerAuthenticator(users, verifiers, firstPassword, clock);
    }

    @Bean
    CallerAuthenticator.Verifiers verifiers(
            PasswordHashing passwords, SecretGenerator secrets, GrantRegistry grants, ServerSettings settings) {
        String localKey = InitialAdministrator.localKey(secrets, settings.dataDirectory());
        return new CallerAuthenticator.Verifiers(passwords, secrets, localKey, grants);
    }

    @Bean
    AccountChanges accounts(AccessStore users) {
        return new AccountChanges(users);
    }

    /** Null: no provider is configured, which is an empty Optional to those who ask for one. */
    @Bean
    @Nullable
    OidcSignIn oidcSignIn(
            AccessStore users,
            AccountChanges accounts,
            PasswordHashing passwords,
            CallerAuthenticator authentication,
            ServerSettings settings,
            Clock clock) {
        OidcSettings oidc = settings.oidc();
        ExternalUsers external = new ExternalUsers(users, accounts, passwords, new SecretGenerator());
        return oidc == null ? null : new OidcSignIn(oidc, authentication, external, clock);
    }

    @Bean
    Budgets budgets(ServerSettings settings, Time time) {
        return new Budgets(settings.protection().rates(), time::nanos);
    }

    @Bean
    CurrentPrincipal currentPrincipal() {
        return new CurrentPrincipal();
    }

    @Bean
    JsonCodec jsonReader() {
        return new JsonCodec();
    }

    @Bean
    DronePlaceNames dronePlaceNames(CloudManager cloud) {
        DronePlaceNames places = new DronePlaceNames(PlaceNames.load()::near);
        cloud.addListener(places);
        return places;
    }

    @Bean
    TrackWriter trackWriter() {
        return new ParquetTrackWriter();
    }

    @Bean
    DroneIdGenerator droneIds(Time time) {
        return new DroneIdGenerator(time.random());
    }

    @Bean
    Path dataDirectory(ServerSettings settings) {
        return settings.dataDirectory();
    }

    @Bean
    RegistrationPolicy registrationPolicy(ServerSettings settings) {
        return settings.registration();
    }

    @Bean
    SystemService.SettingsView shownSettings(ServerSettings settings, StreamPort stream) {
        return new SystemService.SettingsView(
                stream.number(),
                settings.tileAddress(),
                BuildVersion.current(),
                settings.publicMode(),
                PhoneTrustStarter.url(PhoneTrustStarter.of(settings)));
    }
}
