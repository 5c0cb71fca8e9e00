# Texts of both parts of the page, in Arabic; names, figures and order are those of the English texts, the terms those of docs/terms.md.

the-field-kind-is-damaged = الحقل { $name }.kind تالف
the-field-is-damaged = الحقل { $name } تالف
reading = تجري قراءة { $name } …
cannot-be-opened = لا يمكن فتح { $name }
cancelled-nothing-was-changed = أُلغي. لم يتغير شيء.
were-not-taken-the-project = { $files ->
        [one] لم يؤخذ { $names }: تُرك المشروع قبل قراءته.
        [two] لم يؤخذ { $names }: تُرك المشروع قبل قراءتهما.
       *[other] لم تؤخذ { $names }: تُرك المشروع قبل قراءتها.
    }
cannot-be-kept-in-this = لا يمكن في هذا المتصفح حفظ: { $edits } { $step } { $length ->
        [one] دونه
       *[other] دونها
    }؟
the-pair-with-its-marks = الزوج المعروض بمطابقاته وعلاماته وأقنعته وكاميراه
settings = الإعدادات
named-settings = الإعدادات: { $settings }
geoid = الجيوئيد
orthophoto = الصورة المصححة
simulate = محاكاة
results = النتائج
details = التفاصيل
more-of-the-answer = المزيد
less-of-the-answer = أقل
details-of-the-results = التفاصيل: النتائج
clear = مسح
reject = رفض
restore = استعادة
accept = قبول
cancel = إلغاء
edits-by-hand = التعديلات اليدوية
point = النقطة
rejected-by-hand = مرفوضة يدويًا
before = قبل
save = حفظ
rejected-by-hand-2 = مرفوضة يدويًا
by-hand = يدويًا
points = النقاط
linked = مرتبطة
show = إظهار
view = العرض ▾
undo-sign = ↷
redo-sign = ↶
undo = تراجع
redo = إعادة
no-edit-to-undo = لا تعديل يُتراجع عنه
no-edit-to-redo = لا تعديل يُعاد
chosen-not-listed = { $others ->
        [one] مختار آخر غير مدرج
        [two] مختاران آخران غير مدرجين
        [few] { COUNT($others) } مختارات أخرى غير مدرجة
       *[other] { COUNT($others) } مختارًا آخر غير مدرج
    }
nothing-is-chosen = لم يُختر شيء
nothing-is-measured = لا يُقاس شيء
nothing-is-running = لا شيء قيد التنفيذ
nothing-is-changed = لم يُغيَّر شيء
show-why = بيان السبب
orientation = التوجيه
against-the-truth = مقارنة بالحقيقة
matches-2 = المطابقات
px-3 = { FIXED($value, digits: 3) } بكسل
camera = الكاميرا
method = الطريقة
files = الملفات
open-your-photos = افتح صورك …
save-the-project = احفظ المشروع
was-saved = حُفظ { $name }.
px-2 = { FIXED($value, digits: 2) } بكسل
sigma-of-image-observations = ‏σ₀ لأرصاد الصور
moves-the-measured-point-by = يحرك النقطة المقيسة 0.1 بكسل؛ ومع Shift بكسلًا واحدًا
n-1-1-one-image-pixel = ‏1:1: بكسل الصورة ببكسل واحد من الشاشة (1)
shows-one-image-pixel-as = يعرض بكسل الصورة ببكسل واحد من الشاشة
this-browser-offers-no-canvas = لا يوفر هذا المتصفح لوحة للرسم
focal-length = البعد البؤري
pixel-size = حجم البكسل
fit = ملاءمة
undo-3 = تراجع: { $undo }
redo-3 = إعادة: { $redo }

## engine

the-worker-ran-out-of = نفدت ذاكرة العامل ({ $message })
the-worker-broke-off-at = توقف العامل بعطل في البرنامج ({ $message }): نرجو الإبلاغ عنه
cancelled = أُلغي
the-worker-could-not-start = تعذر بدء العامل
the-program-file-could-not = تعذر تحميل ملف البرنامج { $file } (HTTP { $status }). أعد تحميل الصفحة.

## files

the-storage-does-not-answer = لا يستجيب التخزين
another-tab-has-taken-the = استولى لسان تبويب آخر على المشروع
a-later-version-of-this = كتب المشروعَ إصدارٌ أحدث من هذه الصفحة
the-project-is-no-longer = لم يعد المشروع في التخزين
the-storage-is-full = تخزين هذا المتصفح ممتلئ ولا يتسع لهذا التغيير: احذف مشاريع لم تعد تحتاج إليها
the-copy-needs-about = تحتاج النسخة إلى نحو { $size }، ولا يتسع لها تخزين هذا المتصفح: احذف مشاريع لم تعد تحتاج إليها
the-storage-failed = أخفق تخزين هذا المتصفح ({ $name })
the-project = المشروع
another-tab-has-this-project = المشروع مفتوح في لسان تبويب آخر: أغلقه هناك أولًا
a-later-version-of-this-page = كتبه إصدار أحدث من هذه الصفحة

## panel

version-and-licences = الإصدار والتراخيص
close-2 = إغلاق
matches-and-orients-overlapping-photographs = يطابق الصور المتداخلة ويوجهها، على هذا الحاسوب وحده. مرخص بموجب Apache-2.0 أو MIT، كما تختار.
the-page-holds = تحوي الصفحة
its-module-holds = وتحوي وحدتها
so-many-crates =
    { $crates ->
        [zero] لا حزم Rust
        [one] حزمة Rust واحدة
        [two] حزمتا Rust
        [few] { COUNT($crates) } حزم Rust
        [many] { COUNT($crates) } حزمة Rust
       *[other] { COUNT($crates) } حزمة Rust
    }
so-many-actions =
    { $actions ->
        [zero] لا أوامر
        [one] أمر واحد
        [two] أمران
        [few] { $actions } أوامر
        [many] { $actions } أمرًا
       *[other] { $actions } أمر
    }
anywhere = في كل مكان
finds-any-action = يبحث عن أي أمر
lists-all-keys = يسرد جميع المفاتيح
action-about = { $about }: { $action }
setting = إعداد
find-an-action = البحث عن أمر
actions = الأوامر
all-keys = جميع المفاتيح
what-do-you-want-to = ماذا تريد أن تفعل؟
tab = لسان تبويب
no-action-has-these-words = لا أمر بهذه الكلمات.
not-possible-now = غير ممكن الآن
every-picture = كل عرض
keys = المفاتيح
no-residuals = لا شيء
residuals = المتبقيات
default-4 = الافتراضي
default = الافتراضي
default-2 = { $label }: الافتراضي
help = شرح: { $label }
default-3 = الافتراضي: { $meant }
a-number = عدد
or-empty = ، أو فارغ
allowed-the-last-valid-value = المسموح: { $parameter }{ $what }. تبقى آخر قيمة صالحة مستعملة.
empty = فارغ: { $absent }
slider = { $label }، منزلقة
earlier-settings-2 = إعدادات سابقة
close-3 = إغلاق: { $text }
anywhere-after-edits = في كل مكان، بعد التعديلات
takes-back-the-last-edit = يتراجع عن آخر تعديل
makes-the-edit-again = يعيد التعديل
this-browser-keeps-nothing-of = لا يحفظ هذا المتصفح شيئًا من الصفحة (نافذة خاصة، أو تخزينه محجوب): احفظ المشروع ملفًا قبل أن تغادر. { $reason }
the-storage-of-this-browser = تخزين هذا المتصفح ممتلئ: لم تُحفظ آخر التغييرات. ما حُفظ من قبل سليم. احذف مشاريع لم تعد تحتاج إليها، أو احفظ هذا المشروع ملفًا.
the-storage-is-full-and-is = تخزين هذا المتصفح ممتلئ. يُعرض { $title } كما حُفظ آخر مرة: التغييرات التي لم يتسع لها ليست فيه، ولا تُحفظ تغييرات جديدة. احذف مشاريع لم تعد تحتاج إليها، أو احفظ هذا المشروع ملفًا.
the-last-changes-could-not = تعذر حفظ آخر التغييرات: { $reason }. ما حُفظ من قبل سليم. احفظ المشروع ملفًا قبل أن تغادر.
the-browser-has-closed-its = أغلق المتصفح تخزينه، وتعذر فتحه من جديد: { $reason }. قد يكون ما حُفظ قد ضاع. احفظ المشروع ملفًا قبل أن تغادر.
what-this-browser-had-kept = حُذف ما كان هذا المتصفح قد حفظه، وتعذر حفظ { $title } من جديد: { $reason }. احفظ المشروع ملفًا قبل أن تغادر.
is-open-in-another-tab = { $title } مفتوح في لسان تبويب آخر. لهذا اللسان مشروعه. يمكنك الاطلاع على ما حُفظ منه، أو متابعته هنا.
is-open-in-another-tab-this = { $title } مفتوح في لسان تبويب آخر. هذا ما حفظه ذلك اللسان حتى الآن؛ وما يُغيَّر هنا لا يُحفظ.
another-tab-has-taken-over = استولى لسان تبويب آخر على { $title }. ما يُغيَّر هنا لم يعد يُحفظ.
cannot-be-restored-it-stays = لا يمكن استرجاع { $title }: { $reason }. يبقى في التخزين كما هو.
was-not-opened-the-page = لم يُفتح { $title }: انقطعت الصفحة في المرات الأخيرة عند فتحه. هذا مشروع جديد.
projects = المشاريع …
look-at-it = اطلع عليه
take-it-over = تابعه هنا
show-the-latest = إظهار الأحدث
reads-again-what-the-other = يقرأ من جديد ما حفظه اللسان الآخر
goes-on-with-the-project = يتابع المشروع في هذا اللسان
keep-this-as-a-new = احفظ هذا مشروعًا جديدًا
take-it-back = استرده
shows-the-project-as-the = يعرض المشروع كما حفظه اللسان الآخر
save-its-files = احفظ ملفاته
open-it = افتحه
brightness = السطوع
contrast = التباين
brightness-and-contrast = السطوع والتباين
light-changed = { $label }: السطوع { $brightness } %، التباين { $contrast } %
light-reset = إعادة الضبط
light-reset-title = عرض الصور بسطوعها كما هو في ملفاتها
light-percent = { $percent } %
the-last-valid-value-stays = تبقى آخر قيمة صالحة مستعملة.
allowed-or-empty = المسموح: { $instead }، أو فارغ. { $stays }
give-both-numbers-or-empty = أعط العددين كليهما، أو أفرغهما. { $stays }
two-numbers = عددان
allowed = المسموح: { $instead }. { $stays }
holds-settings = { $name } ملف إعدادات: حمّله من «الإعدادات». وُضع جانبًا.
the-file-holds-no-settings = لا يحوي الملف إعدادات لهذه الصفحة
the-file-holds-settings-of = يحوي الملف إعدادات { $subject }، لا إعدادات { $of ->
        [pair] زوج
       *[block] كتلة
    }
there-is-no-setting = لا إعداد باسم { $key }
is-not-allowed = { $label }: القيمة { $value } غير مسموحة
delete = حذف
so-many-images =
    { $images ->
        [zero] لا صور
        [one] صورة واحدة
        [two] صورتان
        [few] { COUNT($images) } صور
        [many] { COUNT($images) } صورة
       *[other] { COUNT($images) } صورة
    }
the-last-changes-on-the = تعذر حفظ آخر تغييرات الصفحة في هذا المتصفح. هل تتركها؟
ask-the-browser-never-to = اطلب من المتصفح ألا يمحوها أبدًا
new-project = مشروع جديد
projects-2 = المشاريع
this-browser-keeps-each-project = يحفظ هذا المتصفح كل مشروع كلما تغيّر. لا شيء يغادر هذا الحاسوب.
nothing-is-kept-yet = لا شيء محفوظ بعد.
about-are-left = {" "}بقي نحو { $quota }.
the-browser-may-clear-it = {" "}قد يمحوها المتصفح حيث تضيق المساحة.
the-projects-take-about = تشغل المشاريع نحو { $own }.{ $left }{ $may }
the-browser-does-not-promise = لا يعد المتصفح بذلك: احفظ المهم ملفًا
open-this-project = افتح هذا المشروع
on-the-page = {" "}· على الصفحة
rename = إعادة تسمية
duplicate = نسخ
copy = { $title } (نسخة)
save-files = حفظ الملفات
new-name-of = الاسم الجديد لـ{ $row }
keep = إبقاء
delete-with-its-images-and = هل تحذف «{ $row }» مع صوره ونتائجه؟ لا يمكن التراجع عن ذلك.
update = تحديث
a-new-version-of-tiepoint = إصدار جديد من Tiepoint جاهز. تُحمَّل به الصفحة من جديد؛ وعملك محفوظ.
later = لاحقًا
the-last-changes-on-the-page = تعذر حفظ آخر تغييرات الصفحة في هذا المتصفح: احفظها ملفًا أولًا.
update-all-the-same = حدّث مع ذلك
another-tab-has-updated-tiepoint = حدّث لسان تبويب آخر Tiepoint. ما على هذه الصفحة لا يُحفظ: احفظه ملفًا ثم حمّل الصفحة من جديد.
load-again = تحميل من جديد
set-all-back = إرجاع الكل إلى الافتراضي
fold-all = طي الكل
unfold-all = بسط الكل
changed = غُيّر { $here }
n-1-setting-differs-from-its = إعداد واحد يختلف عن قيمته الافتراضية.
settings-differ-from-their-defaults =
    { $all ->
        [two] إعدادان يختلفان عن قيمتيهما الافتراضيتين.
        [few] { $all } إعدادات تختلف عن قيمها الافتراضية.
        [many] { $all } إعدادًا تختلف عن قيمها الافتراضية.
       *[other] { $all } إعداد تختلف عن قيمها الافتراضية.
    }
load = تحميل …
settings-of-a-as-a = إعدادات { $of ->
        [pair] زوج
       *[block] كتلة
    }، ملفًا
takes-settings-that-were-saved = يأخذ إعدادات محفوظة؛ وتعود سائر الإعدادات إلى قيمها الافتراضية
saves-what-differs-from-the = يحفظ ما يختلف عن القيم الافتراضية، بصيغة JSON
settings-as-a-file = الإعدادات في ملف
settings-2 = الإعدادات · { $changed }
mean = المتوسط
contains = يحوي
rows-that-contain-this-text = الصفوف التي تحوي هذا النص
rows-within-these-limits-as = الصفوف ضمن هذه الحدود، مثل 2..5 أو ‎>2‎ أو ‎≤0.5‎
is-no-number-or-range = «{ $typed }» ليس عددًا ولا مجالًا. المسموح: 2 أو 2..5 أو ‎>2‎ أو ‎≤0.5‎. تبقى الصفوف كما هي.
in-2 = {" "}بوحدة { $unit }
filter = تصفية: { $label }{ $what }
show-all = إظهار الكل
takes-away-what-is-typed = يزيل تصفية هذا الجدول
saves-the-rows-and-columns = يحفظ الصفوف والأعمدة الظاهرة
copy-2 = نسخ
copies-the-rows-and-columns = ينسخ الصفوف والأعمدة الظاهرة لجدول بيانات
columns = الأعمدة ▾
of-8 = { $shown } من{" "}
copied = نُسخ
not-copied = لم يُنسخ
theme-auto = المظهر: تلقائي
theme-light = المظهر: فاتح
theme-dark = المظهر: داكن
theme = المظهر
language-of-the-page = لغة الصفحة: العربية أو الإنجليزية
light-dark-or-as-the = فاتح أو داكن أو كما في النظام
zoom-out = تصغير (−)
zoom-in = تكبير (+)
fit-0 = ملاءمة: { $whole } (0)

## text

principal-point = النقطة الأساسية
radial-distortion = التشوه الشعاعي
tangential-distortion = التشوه المماسي
origin-in-the-scan-2 = المبدأ في المسح الضوئي
this-value-is-not-allowed = { $label }: هذه القيمة غير مسموحة. تبقى آخر قيمة صالحة مستعملة.
and-between = {" "}و
files-cannot-be-opened =
    { $files ->
        [one] لا يمكن فتح { $names }: { $reason }
        [two] لا يمكن فتح ملفين ({ $names }): { $reason }
        [few] لا يمكن فتح { COUNT($files) } ملفات ({ $names }): { $reason }
       *[other] لا يمكن فتح { COUNT($files) } ملفًا ({ $names }): { $reason }
    }
comma-between-names = ،{" "}
names-and-more = { $first } و{ COUNT($more) } غيرها
without-images = بلا صور
two-names = { $first } و{ $second }
and-more-images = { $first } و{ $images ->
        [one] صورة أخرى
        [two] صورتان أخريان
        [few] { COUNT($images) } صور أخرى
       *[other] { COUNT($images) } صورة أخرى
    }
kb = { COUNT($bytes) } كيلوبايت

## view

or = {" "}أو{" "}
moves-the-picture-with-shift = يحرك الصورة؛ ومع Shift أبعد
key-enlarges = يكبّر
makes-smaller = يصغّر
shows-the-whole-picture = يعرض الصورة كلها

## The page as it is before the program is there. [K] is a key.

tiepoint-image-matching-and-relative = ‏Tiepoint: مطابقة الصور وتوجيهها النسبي
to-the-images = إلى الصور
menu = القائمة
open-images = افتح صورًا …
sample-pair = زوج نموذجي
exchange-the-left-and-the = تبديل الصورة اليسرى باليمنى
swap = تبديل
export-2 = تصدير ▾
all-that-is-known-of = كل ما يُعرف عن الزوج: افتحه هنا من جديد
project-2 = مشروع
matches-csv = المطابقات CSV
all-json = الكل JSON
one-html-file-with-pictures = ملف HTML واحد فيه الصور، وجداول جميع الاستراتيجيات، والمتبقيات، والموثوقية، والمعاملات
report = تقرير
both-images-without-distortion-with = الصورتان بلا تشويه، وما تُظهرانه في الصفوف نفسها؛ وصورة مجسَّمة؛ ومعاملاتها
epipolar-images = الصورتان القطبيتان
picture-png = صورة PNG
project-and-page = المشروع والصفحة
puts-this-project-aside-in = يضع هذا المشروع جانبًا في قائمة المشاريع ويبدأ مشروعًا جديدًا
new = جديد
projects-that-this-browser-keeps = المشاريع التي يحفظها هذا المتصفح: فتح، وإعادة تسمية، ونسخ، وحذف
finds-any-action-ctrl-k = يبحث عن أي أمر (Ctrl+K)؛ و? يسرد جميع المفاتيح
find = بحث …
image-fiducial-camera-or-project = ملفات صور أو علامات إطارية أو كاميرا أو مشروع
progress-of-the-run = تقدم التشغيل
image-pair = زوج صور
left-and-right-image-with = الصورة اليسرى واليمنى مع النقاط وخطوط المطابقات
where-did-each-photo-stand-2 = أين كانت كل صورة، وماذا تُظهر كلتاهما؟
drop-overlapping-photographs-anywhere-on = أفلت صورًا متداخلة في أي مكان من هذه الصفحة، صورتين أو أكثر. تحصل على:
where-the-cameras-stood-to = موضع الكاميرات بعضها من بعض، ودورانها
points-that-the-photos-have = النقاط المشتركة بين الصور، ودقتها
files-for-other-programs-and = ملفات لبرامج أخرى، وتقرير
try-a-sample-pair = جرّب زوجًا نموذجيًا
nothing-leaves-this-computer-jpeg = لا شيء يغادر هذا الحاسوب. JPEG وPNG وTIFF (‏8 و16 بت) وBMP وPNM وWebP؛ ويمكن أيضًا إفلات العلامات الإطارية (CSV) وبيانات الكاميرا (JSON) والأقنعة (صور في اسمها ”mask“).
images-are-processed-on-this = تُعالَج الصور على هذا الحاسوب؛ ولا يُرسَل شيء.
keys-hint = السحب أو الأسهم للتحريك · العجلة و[+] [−] للتكبير · [N] [P] للنقاط · [?] جميع المفاتيح · [Ctrl] [K] للبحث عن أمر
finds-tie-points-of-overlapping = يجد نقاط الربط بين صور متداخلة ويوجه أزواجها وكتلها، في المتصفح.
images-2 = الصور
block = الكتلة
export = تصدير
pair = زوج
what-is-matched = ما يُطابَق
run = تشغيل
view-2 = العرض
try-a-sample-block = جرّب كتلة نموذجية
a-plain-word-on-whether = كلمة صريحة: هل يوثق بالنتيجة، ولماذا
the-file-of-the-page =
    { $status ->
        [none] تعذر تحميل أحد ملفات الصفحة، { $file }
       *[other] تعذر تحميل أحد ملفات الصفحة، { $file }: HTTP { $status }
    }
the-block-was-not-loaded = جزء الصفحة الخاص بالكتل غير متاح: { $error } اضغط ثانيةً لإعادة المحاولة.
a-part-of-the-page = تعذر تحميل جزء من الصفحة.
try-again = أعد المحاولة
opening-kept-work = يجري فتح «{ $title }» الذي حفظه هذا المتصفح …
history-earlier = { $edits ->
    [one] تعديل سابق واحد …
    [two] تعديلان سابقان …
    [few] { $edits } تعديلات سابقة …
   *[other] { $edits } تعديلًا سابقًا …
  }
history-later = { $edits ->
    [one] تعديل لاحق واحد …
    [two] تعديلان لاحقان …
    [few] { $edits } تعديلات لاحقة …
   *[other] { $edits } تعديلًا لاحقًا …
  }
